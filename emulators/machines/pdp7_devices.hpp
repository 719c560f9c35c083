// The devices that a PDP-7 can be given by name. If several request a data break at once, the first in this list is served
// first.
//
// To add a device, write a class like the others (../core/iot_device.hpp), and add a line here.
#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include "../core/iot_device.hpp"
#include "../pdp7/clock.hpp"
#include "../pdp7/device_setup.hpp"
#include "../pdp7/paper_tape.hpp"
#include "../pdp7/rb09.hpp"
#include "../pdp7/teletype.hpp"
#include "../type340/display.hpp"

namespace sightline::pdp7 {

struct KnownDevice {
  core::IotDeviceInfo info;
  std::unique_ptr<core::IotDevice> (*make)(const DeviceSetup& setup);
};

template <class Device>
inline constexpr KnownDevice known{
    Device::info, [](const DeviceSetup& setup) -> std::unique_ptr<core::IotDevice> { return std::make_unique<Device>(setup); }};

inline constexpr std::array known_devices{
    known<Rb09>,  // tolerates the shortest wait
    known<type340::Display>,
    known<Clock>,
    known<Reader>,
    known<Punch>,
    known<Keyboard>,
    known<Printer>,
};

// Their descriptions, for programs that make none, such as an assembler: without linking the devices.
inline constexpr auto device_infos = [] {
  std::array<core::IotDeviceInfo, known_devices.size()> infos;
  for (std::size_t i = 0; i < infos.size(); ++i) infos[i] = known_devices[i].info;
  return infos;
}();

}  // namespace sightline::pdp7
