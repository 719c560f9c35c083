// Emulated time. The PDP-7 and the Type 340 share one clock that counts whole nanoseconds from the start of a run.
//
// `Instant` (when) and `Duration` (how long) are kept apart by std::chrono; machine cycles are a unit of their own
// that converts to nanoseconds without loss. No emulated time ever comes from the host's clock.
#pragma once

#include <chrono>
#include <cstdint>
#include <ratio>

namespace sightline::core {

using Duration = std::chrono::duration<std::int64_t, std::nano>;

struct EmulatedClock {
  using rep = std::int64_t;
  using period = std::nano;
  using duration = Duration;
  using time_point = std::chrono::time_point<EmulatedClock, Duration>;
  static constexpr bool is_steady = true;
};
using Instant = EmulatedClock::time_point;

// Later than any instant a run can reach: the deadline of a device that will do nothing by itself.
inline constexpr Instant never = Instant::max();

[[nodiscard]] constexpr Instant at_nanoseconds(std::int64_t ns) { return Instant(Duration(ns)); }
[[nodiscard]] constexpr std::int64_t nanoseconds_of(Instant t) { return t.time_since_epoch().count(); }

}  // namespace sightline::core
