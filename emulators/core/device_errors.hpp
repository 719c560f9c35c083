// The error texts for attaching a device to a machine by name.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "device.hpp"

namespace sightline::core {

// The number of characters to insert, remove or replace to turn one into the other.
[[nodiscard]] inline std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row[b.size()];
}

// found WHAT "nmae", expected one of: name, ...; did you mean "name"?
[[nodiscard]] inline std::string unknown_name(std::string_view what, std::string_view name,
                                              std::span<const std::string_view> names) {
  std::string text = "found " + std::string(what) + " \"" + std::string(name) + "\", expected ";
  if (names.empty()) return text + "none";
  if (names.size() > 1) text += "one of: ";
  std::string_view nearest;
  std::size_t least = 2 + name.size() / 4;  // the first distance that is too far
  for (const std::string_view each : names) {
    text += (each.data() == names.front().data() ? "" : ", ") + std::string(each);
    constexpr std::size_t longest_compared = 100;
    const std::size_t distance = name.size() <= longest_compared ? edit_distance(name, each) : least;
    if (distance >= least || distance >= name.size()) continue;
    least = distance;
    nearest = each;
  }
  if (!nearest.empty()) text += "; did you mean \"" + std::string(nearest) + "\"?";
  return text;
}

// What is wrong with the settings of a device; empty if nothing is.
[[nodiscard]] inline std::string wrong_setting(std::string_view device, std::span<const DeviceOption> options,
                                               std::span<const Setting> settings) {
  for (const Setting& setting : settings) {
    const auto option =
        std::find_if(options.begin(), options.end(), [&](const DeviceOption& each) { return each.name == setting.name; });
    const std::string of_device = " of the " + std::string(device);
    if (option == options.end()) {
      std::vector<std::string_view> names;
      for (const DeviceOption& each : options) names.push_back(each.name);
      return unknown_name("option" + of_device, setting.name, names);
    }
    if (setting.value < option->least || setting.value > option->most) {
      return "found " + std::to_string(setting.value) + " for the option " + std::string(setting.name) + of_device +
             ", expected " + std::to_string(option->least) + " to " + std::to_string(option->most);
    }
    if (std::count_if(settings.begin(), settings.end(), [&](const Setting& each) { return each.name == setting.name; }) > 1)
      return "found the option " + std::string(setting.name) + of_device + " twice, expected it once";
  }
  return {};
}

}  // namespace sightline::core
