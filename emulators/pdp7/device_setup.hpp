// What a device of the PDP-7 is made from.
#pragma once

#include "../core/iot_device.hpp"
#include "timing.hpp"

namespace sightline::pdp7 {

struct DeviceSetup : core::IotDeviceSetup {
  const Timing& timing;
};

}  // namespace sightline::pdp7
