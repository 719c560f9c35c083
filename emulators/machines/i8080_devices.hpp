// The devices that an 8080 can be given by name, in the order of snapshots and reports.
//
// To add a device, write a class like the others in ../devices (core/port_device.hpp), and add a line here.
#pragma once

#include <array>
#include <memory>

#include "../core/port_device.hpp"
#include "../devices/alt256.hpp"
#include "../devices/altair_serial.hpp"
#include "../devices/bus_master.hpp"
#include "../devices/calcomp565.hpp"
#include "../devices/ef9365.hpp"
#include "../devices/minigraf0507.hpp"
#include "../devices/parallel_link.hpp"
#include "../devices/priority_board.hpp"
#include "../devices/sense_switches.hpp"
#include "../devices/serial_link.hpp"

namespace sightline::i8080 {

struct KnownDevice {
  const core::PortDeviceInfo* info;
  std::unique_ptr<core::PortDevice> (*make)(const core::PortDeviceSetup& setup);
};

template <class Device>
inline constexpr KnownDevice known{
    &Device::info, [](const core::PortDeviceSetup& setup) -> std::unique_ptr<core::PortDevice> { return std::make_unique<Device>(setup); }};

inline constexpr std::array known_devices{
    known<devices::Ef9365>,
    known<devices::Alt256>,
    known<devices::CalComp565>,
    known<devices::Minigraf0507>,
    known<devices::ParallelLink>,
    known<devices::SerialLink>,
    known<devices::AltairSio>,
    known<devices::Altair2Sio>,
    known<devices::Altair2SioB>,
    known<devices::SenseSwitches>,
    known<devices::PriorityBoard>,
    known<devices::BusMaster>,
};

}  // namespace sightline::i8080
