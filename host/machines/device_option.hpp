// The option --device NAME[,OPTION=N...] of `sightline run`: attaches a device of the machine's list that has no option of
// its own, so that a new device can be used as soon as it is listed. A machine without such devices has no --device.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "emulators/core/device.hpp"
#include "host/base/json.hpp"
#include "host/machines/machine.hpp"

namespace sightline::machines {

// A device as --device lists it.
struct ListedDevice {
  std::string_view name;
  std::string_view help;
  std::span<const core::DeviceOption> options;
};

struct DeviceChoice {
  std::string_view name;  // of the list
  std::vector<core::Setting> settings;
};

[[nodiscard]] std::optional<Option> device_option(std::span<const ListedDevice> devices);
// The devices and their settings, for the end of the text of --help; empty without devices.
[[nodiscard]] std::string device_help(std::span<const ListedDevice> devices);
// Errors: an unknown device or setting, a device or a setting given twice, a value out of its bounds.
[[nodiscard]] Result<std::vector<DeviceChoice>> read_devices(std::span<const std::string> texts,
                                                             std::span<const ListedDevice> devices);
// The choice in the syntax of the option.
[[nodiscard]] std::string device_text(const DeviceChoice& choice);

// "lines printed 5, pages 2": a device's counts for a report, without zeros; "nothing" if all are zero.
[[nodiscard]] std::string counts_text(std::span<const core::Count> counts);
[[nodiscard]] base::Json counts_json(std::span<const core::Count> counts);

}  // namespace sightline::machines
