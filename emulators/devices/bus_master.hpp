// A board that takes the bus from the processor by HOLD, once or periodically, always for the same time. It has no ports
// and does nothing with the bus.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "../core/port_device.hpp"
#include "../core/tstates.hpp"

namespace sightline::devices {

// HOLD is high for `length` T-states from T-state `first` on, and again every `period` T-states.
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
  // The first T-state at or after `t` in which HOLD is low.
  [[nodiscard]] constexpr core::TStateInstant hold_ends(core::TStateInstant t) const {
    const std::int64_t since = core::t_states_of(t) - first;
    if (since < 0 || within(since) >= length) return t;
    return t + core::TStates(length - within(since));
  }

 private:
  // T-states since HOLD last rose.
  [[nodiscard]] constexpr std::int64_t within(std::int64_t since) const { return period == 0 ? since : since % period; }
};

static_assert(HoldTimes{}.next_hold(core::at_t_state(5)) == core::never_t);
static_assert(HoldTimes{10, 4, 0}.next_hold(core::at_t_state(0)) == core::at_t_state(10));
static_assert(HoldTimes{10, 4, 0}.next_hold(core::at_t_state(13)) == core::at_t_state(13));
static_assert(HoldTimes{10, 4, 0}.next_hold(core::at_t_state(14)) == core::never_t);
static_assert(HoldTimes{10, 4, 20}.next_hold(core::at_t_state(14)) == core::at_t_state(30));
static_assert(HoldTimes{10, 4, 20}.hold_ends(core::at_t_state(31)) == core::at_t_state(34));
static_assert(HoldTimes{10, 4, 20}.hold_ends(core::at_t_state(34)) == core::at_t_state(34));

class BusMaster final : public core::PortDevice {
 public:
  static constexpr std::int64_t longest = std::numeric_limits<std::uint32_t>::max();
  static constexpr std::array options{core::DeviceOption{"first", "T-state in which HOLD rises for the first time", 0, 0, longest},
                                      core::DeviceOption{"length", "T-states for which it stays; 0: never", 0, 0, longest},
                                      core::DeviceOption{"period", "T-states from one rise to the next; not more than length: once", 0,
                                                         0, longest}};
  static constexpr core::PortDeviceInfo info{.name = "bus-master",
                                             .help = "takes the bus from the processor",
                                             .choice = "bus-master",
                                             .kind = core::PortDeviceKind::special,
                                             .options = options,
                                             .has_state = false};

  explicit BusMaster(const core::PortDeviceSetup& setup)
      : BusMaster(HoldTimes{setup.value(info, "first"), setup.value(info, "length"), setup.value(info, "period")}) {}
  // A period that is not longer than the length means once.
  explicit BusMaster(const HoldTimes& times) : times_(times) {
    if (times_.period <= times_.length) times_.period = 0;
  }

  [[nodiscard]] bool drives_hold() const override { return times_.length != 0; }
  [[nodiscard]] core::TStateInstant next_hold(core::TStateInstant t) const override { return times_.next_hold(t); }
  [[nodiscard]] core::TStateInstant hold_ends(core::TStateInstant t) const override { return times_.hold_ends(t); }

 private:
  HoldTimes times_;
};

}  // namespace sightline::devices
