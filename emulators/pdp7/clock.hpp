// The real-time clock, IOT device 00: while it is on, it increments location 7 in a data break at every period of the
// mains. When the count goes from 777777 to 0 the clock flag rises and requests a program interrupt.
//
// The mains phase runs from instant zero whether the clock is on or not, so the first tick after CLON comes within a
// period.
// Source: PDP-4 manual page 23.
#pragma once

#include <array>
#include <cstdint>

#include "../core/iot_device.hpp"
#include "../core/state_visitor.hpp"
#include "../core/time.hpp"
#include "../core/word.hpp"
#include "device_setup.hpp"
#include "status.hpp"

namespace sightline::pdp7 {

class Clock final : public core::IotDevice {
 public:
  static constexpr std::array<std::uint8_t, 1> codes{000};
  static constexpr std::array iots{
      core::IotName{"clsf", 0700001, "skip if clock flag"},
      core::IotName{"clof", 0700004, "clock off, clear its flag"},
      core::IotName{"clon", 0700044, "clock on, clear its flag"},
  };
  static constexpr core::IotDeviceInfo info{
      .name = "clock", .help = "the real-time clock, which counts location 7", .codes = codes, .iots = iots};

  static constexpr std::uint16_t count_address = 7;

  // `hertz` below 1 is taken as 1. `tick_cycles`: machine cycles per tick.
  explicit Clock(std::int64_t hertz, int tick_cycles = 1) : hertz_(hertz < 1 ? 1 : hertz) { tick_.cycles = tick_cycles; }
  explicit Clock(const DeviceSetup& setup) : Clock(setup.timing.clock_hertz, setup.timing.clock_tick_cycles) {}

  [[nodiscard]] bool on() const { return on_; }
  [[nodiscard]] bool flag() const { return flag_; }

  void iot(core::Instant now, std::uint32_t word, core::IotReply& reply) override {
    reply.test(word, flag_);
    if ((word & 04U) == 0) return;
    reply.answered |= 04U;
    if ((word & 040U) != 0) {
      turn_on(now);
    } else {
      turn_off();
    }
  }
  void advance(core::Instant now) override { ticks_ = now >= deadline(); }
  // The next tick; instants are rounded down to a nanosecond, without drift.
  [[nodiscard]] core::Instant deadline() const override {
    if (!on_) return core::never;
    return core::at_nanoseconds(next_period_ / hertz_ * nanoseconds_in_a_second +
                                next_period_ % hertz_ * nanoseconds_in_a_second / hertz_);
  }
  [[nodiscard]] const core::DataBreak* data_break() const override { return ticks_ ? &tick_ : nullptr; }
  void end_break(core::Instant end, core::Word18 count) override {
    static_cast<void>(end);
    ticks_ = false;
    ++next_period_;
    if (count.value() == 0) flag_ = true;
  }

  [[nodiscard]] bool interrupt_request() const override { return flag_; }
  [[nodiscard]] std::uint32_t status(core::Instant) override {
    return (flag_ ? status::clock : 0U) | (on_ ? status::clock_on : 0U);
  }
  // CAF and START turn the clock off, too.
  void clear_flags(core::Instant) override { turn_off(); }

  void visit_state(core::StateVisitor& visit) override {
    visit("next_period", next_period_, longest_run * hertz_);
    visit("on", on_);
    visit("flag", flag_);
  }
  void require_time(core::StateVisitor& visit, core::Instant now) override {
    visit.require(deadline() > now - core::seconds(1), "clock", "no tick of an earlier second");
  }

 private:
  static constexpr std::int64_t nanoseconds_in_a_second = 1'000'000'000;
  static constexpr std::int64_t longest_run = 9'200'000'000;  // seconds that fit into an Instant

  void turn_on(core::Instant now) {
    on_ = true;
    flag_ = ticks_ = false;
    const std::int64_t seconds = core::nanoseconds_of(now) / nanoseconds_in_a_second;
    const std::int64_t rest = core::nanoseconds_of(now) % nanoseconds_in_a_second;
    next_period_ = seconds * hertz_ + rest * hertz_ / nanoseconds_in_a_second + 1;
  }
  void turn_off() { on_ = flag_ = ticks_ = false; }

  std::int64_t hertz_;
  core::DataBreak tick_{.direction = core::DataBreak::Direction::count, .address = count_address};
  bool ticks_ = false;  // a tick waits for its cycle
  std::int64_t next_period_ = 0;
  bool on_ = false;
  bool flag_ = false;
};

}  // namespace sightline::pdp7
