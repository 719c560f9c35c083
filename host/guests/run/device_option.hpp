// The option --device NAME[,SETTING=N...] of `sightline run`: it attaches a device of the machine's list that no option of its
// own attaches, so that a new device can be used as soon as it is in the list. A machine without such devices has no --device.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "emulators/core/device.hpp"
#include "host/base/json.hpp"
#include "host/guests/run/machine.hpp"

namespace sightline::guests::run {

// What the option says of a device.
struct ListedDevice {
  std::string_view name;
  std::string_view help;
  std::span<const core::DeviceOption> settings;
};

[[nodiscard]] std::optional<Option> device_option(std::span<const ListedDevice> devices);
// The devices and their settings, for the end of what --help explains; empty without devices.
[[nodiscard]] std::string device_help(std::span<const ListedDevice> devices);

struct DeviceChoice {
  std::string text;  // as it was given
  std::string name;
  std::vector<std::pair<std::string, std::int64_t>> values;

  // They point into this object.
  [[nodiscard]] std::vector<core::Setting> settings() const {
    std::vector<core::Setting> settings;
    for (const auto& [setting, value] : values) settings.push_back({setting, value});
    return settings;
  }
};
// Whether there is such a device, with such settings, is for the machine to say.
[[nodiscard]] Result<std::vector<DeviceChoice>> read_devices(std::span<const std::string> texts);

// "5 lines, 2 pages": what a device has counted, for a report.
[[nodiscard]] std::string counts_text(std::span<const core::Count> counts);
[[nodiscard]] base::Json counts_json(std::span<const core::Count> counts);

}  // namespace sightline::guests::run
