// HOLD at times that are laid down beforehand: a board that takes the bus from the processor, once or again and again, for
// as long as it always does.
#pragma once

#include <cstdint>

#include "../core/tstates.hpp"

namespace sightline::machines {

// HOLD is high for `length` T-states from T-state `first` on, and again `period` after the beginning of each.
struct HoldTimes {
  std::int64_t first = 0;   // at least 0
  std::int64_t length = 0;  // at least 1; 0: never
  std::int64_t period = 0;  // more than `length`; 0: once

  // The first T-state at or after `t` in which HOLD is high.
  [[nodiscard]] constexpr core::TStateInstant next_hold(core::TStateInstant t) const {
    const std::int64_t since = core::t_states_of(t) - first;
    if (length == 0) return core::never_t;
    if (since < 0) return core::at_t_state(first);
    if (within(since) < length) return t;
    return period == 0 ? core::never_t : t + core::TStates(period - within(since));
  }
  // The first at or after `t` in which it is low.
  [[nodiscard]] constexpr core::TStateInstant hold_ends(core::TStateInstant t) const {
    const std::int64_t since = core::t_states_of(t) - first;
    if (since < 0 || within(since) >= length) return t;
    return t + core::TStates(length - within(since));
  }

 private:
  // Since HOLD last rose.
  [[nodiscard]] constexpr std::int64_t within(std::int64_t since) const { return period == 0 ? since : since % period; }
};

static_assert(HoldTimes{}.next_hold(core::at_t_state(5)) == core::never_t);
static_assert(HoldTimes{10, 4, 0}.next_hold(core::at_t_state(0)) == core::at_t_state(10));
static_assert(HoldTimes{10, 4, 0}.next_hold(core::at_t_state(13)) == core::at_t_state(13));
static_assert(HoldTimes{10, 4, 0}.next_hold(core::at_t_state(14)) == core::never_t);
static_assert(HoldTimes{10, 4, 20}.next_hold(core::at_t_state(14)) == core::at_t_state(30));
static_assert(HoldTimes{10, 4, 20}.hold_ends(core::at_t_state(31)) == core::at_t_state(34));
static_assert(HoldTimes{10, 4, 20}.hold_ends(core::at_t_state(34)) == core::at_t_state(34));

}  // namespace sightline::machines
