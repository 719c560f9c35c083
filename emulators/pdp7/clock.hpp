// The real-time clock: while it is on, every period of the mains counts location 7 up by one in a stolen
// cycle; when the count passes from 777777 to 0 the clock flag rises and asks for a program interrupt.
//
// The mains runs from instant zero whether the clock is on or not, so the first tick after CLON comes within
// a period. The machine does the counting (it owns core memory); this holds the switch, the flag and the
// phase.
#pragma once

#include <cstdint>

#include "emulators/core/time.hpp"

namespace sightline::pdp7 {

class Clock {
 public:
  // `hertz` of 1 or more; less is taken as 1.
  explicit constexpr Clock(std::int64_t hertz) : hertz_(hertz < 1 ? 1 : hertz) {}

  constexpr void turn_on(core::Instant now) {
    on_ = true;
    flag_ = false;
    next_period_ = core::nanoseconds_of(now) * hertz_ / nanoseconds_in_a_second + 1;
  }
  constexpr void turn_off() { on_ = flag_ = false; }

  [[nodiscard]] constexpr bool on() const { return on_; }
  [[nodiscard]] constexpr bool flag() const { return flag_; }
  constexpr void raise_flag() { flag_ = true; }

  // The next tick; instants are rounded down to a nanosecond, without drift.
  [[nodiscard]] constexpr core::Instant deadline() const {
    return on_ ? core::at_nanoseconds(next_period_ * nanoseconds_in_a_second / hertz_) : core::never;
  }
  // True once for every tick at or before `now`.
  constexpr bool take_tick(core::Instant now) {
    if (now < deadline()) return false;
    ++next_period_;
    return true;
  }

 private:
  static constexpr std::int64_t nanoseconds_in_a_second = 1'000'000'000;

  std::int64_t hertz_;
  std::int64_t next_period_ = 0;
  bool on_ = false;
  bool flag_ = false;
};

}  // namespace sightline::pdp7
