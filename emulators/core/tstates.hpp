// Emulated time of the 8080 machines: T-states, the periods of the processor's clock, counted from the start of a run.
//
// The length of a T-state is a parameter of the machine. ClockRate converts, in integer arithmetic, where a device's data
// sheet gives seconds. No other conversion exists: T-states and nanoseconds are different types (time.hpp).
#pragma once

#include <cstdint>

#include "time.hpp"

namespace sightline::core {

struct TState;
using TStates = TickCount<TState>;
using TStateInstant = TickInstant<TState>;

// Later than any instant a run can reach: the deadline of a device without a pending event.
inline constexpr TStateInstant never_t = TStateInstant::max();

[[nodiscard]] constexpr TStateInstant at_t_state(std::int64_t t) { return TStateInstant(TStates(t)); }
[[nodiscard]] constexpr std::int64_t t_states_of(TStateInstant t) { return t.time_since_epoch().count(); }

// The frequency of the processor's clock. Both conversions are exact for 1 Hz to 1 GHz and do not overflow within 290
// years; later instants, `never_t` included, become `never`.
struct ClockRate {
  std::int64_t hertz = 3'000'000;

  // The beginning of T-state t, rounded down to a whole nanosecond. t must not be negative.
  [[nodiscard]] constexpr Instant to_nanoseconds(TStateInstant t) const {
    const std::int64_t seconds = t_states_of(t) / hertz;
    const std::int64_t rest = t_states_of(t) % hertz;
    if (seconds >= longest_run) return never;
    return at_nanoseconds(seconds * second + rest * second / hertz);
  }
  // The fewest T-states that last at least `busy`, which must not be negative.
  [[nodiscard]] constexpr TStates t_states_in(Duration busy) const {
    const std::int64_t seconds = busy.count() / second;
    const std::int64_t rest = busy.count() % second;
    return TStates(seconds * hertz + (rest * hertz + second - 1) / second);
  }

 private:
  static constexpr std::int64_t second = 1'000'000'000;
  static constexpr std::int64_t longest_run = 9'200'000'000;  // seconds that fit into an Instant
};

[[nodiscard]] constexpr double in_seconds(TStates t, ClockRate clock = {}) {
  return static_cast<double>(t.count()) / static_cast<double>(clock.hertz);
}

static_assert(ClockRate{}.to_nanoseconds(at_t_state(1)) == at_nanoseconds(333));
static_assert(ClockRate{}.to_nanoseconds(at_t_state(3'000'003)) == at_nanoseconds(1'000'001'000));
static_assert(ClockRate{}.to_nanoseconds(never_t) == never);
static_assert(ClockRate{}.t_states_in(Duration(333)) == TStates(1));
static_assert(ClockRate{}.t_states_in(Duration(334)) == TStates(2));
static_assert(ClockRate{}.t_states_in(Duration(1'000'000'000)) == TStates(3'000'000));
static_assert(in_seconds(TStates(1'500'000)) == 0.5);
static_assert(in_seconds(TStates(500'000), ClockRate{2'000'000}) == 0.25);

}  // namespace sightline::core
