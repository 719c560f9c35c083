// The sense switches of an Altair 8800: the upper eight address switches of its front panel, which a program reads at port
// FF. Source: MITS, "Altair 8800 Operator's Manual" (1975).
#pragma once

#include <array>
#include <cstdint>

#include "../core/port_device.hpp"
#include "../core/tstates.hpp"

namespace sightline::devices {

class SenseSwitches final : public core::PortDevice {
 public:
  static constexpr std::array ports{core::PortRange{0xFF, 0xFF}};
  static constexpr std::array options{core::DeviceOption{"value", "of the switches A15 to A8", 0, 0, 255}};
  static constexpr core::PortDeviceInfo info{.name = "sense",
                                             .help = "sense switches of an Altair's front panel",
                                             .choice = "sense",
                                             .kind = core::PortDeviceKind::special,
                                             .reads = ports,
                                             .options = options,
                                             .has_state = false};

  explicit SenseSwitches(const core::PortDeviceSetup& setup) : value_(static_cast<std::uint8_t>(setup.value(info, "value"))) {}

  [[nodiscard]] std::uint8_t in(std::uint8_t, core::TStateInstant) override { return value_; }

 private:
  std::uint8_t value_;
};

}  // namespace sightline::devices
