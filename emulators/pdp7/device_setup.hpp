// The arguments of a PDP-7 device's constructor.
#pragma once

#include "../core/iot_device.hpp"
#include "timing.hpp"

namespace sightline::pdp7 {

struct DeviceSetup : core::IotDeviceSetup {
  const Timing& timing;
};

}  // namespace sightline::pdp7
