// See device_option.hpp.
#include "host/machines/device_option.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>

#include "host/base/number.hpp"

namespace sightline::machines {

namespace {

// The element with the name; null if there is none.
template <class Named>
const Named* find_named(std::span<const Named> all, std::string_view name) {
  const auto found = std::find_if(all.begin(), all.end(), [name](const Named& each) { return each.name == name; });
  return found == all.end() ? nullptr : &*found;
}

template <class Named>
std::string names_of(std::span<const Named> all) {
  std::string names;
  for (const Named& each : all) names += (names.empty() ? "" : ", ") + std::string(each.name);
  return names;
}

// Removes and returns the text before the next comma; removes the comma too.
std::string_view take_part(std::string_view& text) {
  const std::size_t comma = std::min(text.find(','), text.size());
  const std::string_view part = text.substr(0, comma);
  text.remove_prefix(std::min(comma + 1, text.size()));
  return part;
}

Result<core::Setting> read_setting(std::string_view text, const ListedDevice& device) {
  const std::size_t equals = std::min(text.find('='), text.size());
  const std::string_view name = text.substr(0, equals);
  const core::DeviceOption* const option = find_named(device.options, name);
  if (option == nullptr || equals == text.size()) {
    return base::usage_error(fmt::format("--device {}: found \"{}\", expected {}", device.name, text,
                             device.options.empty() ? "no setting" : "SETTING=N with one of " + names_of(device.options)));
  }
  const std::string_view digits = text.substr(equals + 1);
  const auto value = base::whole_number<std::int64_t>(digits, 10);
  if (!value || *value < option->least || *value > option->most) {
    return base::usage_error(fmt::format("--device {},{}: found \"{}\", expected a whole decimal number, {} to {}", device.name, name, digits,
                             option->least, option->most));
  }
  return core::Setting{option->name, *value};
}

Result<DeviceChoice> read_device(std::string_view text, std::span<const ListedDevice> devices) {
  const bool has_comma = text.find(',') != std::string_view::npos;
  const std::string_view name = take_part(text);
  const ListedDevice* const device = find_named(devices, name);
  if (device == nullptr) return base::usage_error(fmt::format("--device: found \"{}\", expected one of {}", name, names_of(devices)));
  DeviceChoice choice{device->name, {}};
  for (bool more = has_comma; more;) {
    more = text.find(',') != std::string_view::npos;
    auto setting = read_setting(take_part(text), *device);
    if (!setting) return setting.error();
    if (find_named(std::span<const core::Setting>(choice.settings), setting->name) != nullptr)
      return base::usage_error(fmt::format("--device {}: found {} twice, expected it once", device->name, setting->name));
    choice.settings.push_back(*setting);
  }
  return choice;
}

}  // namespace

std::optional<Option> device_option(std::span<const ListedDevice> devices) {
  if (devices.empty()) return std::nullopt;
  return Option{.kind = OptionKind::list,
                .name = "--device",
                .argument = "NAME[,SETTING=N...]",
                .help = "Attach a further device; names and settings below"};
}

std::string device_help(std::span<const ListedDevice> devices) {
  if (devices.empty()) return {};
  std::string text = "\nDevices that --device attaches, and their settings (default, bounds):\n";
  for (const ListedDevice& device : devices) {
    text += fmt::format("  {:<20} {}\n", device.name, device.help);
    for (const core::DeviceOption& option : device.options)
      text += fmt::format("    {:<18} {}: {} ({} to {})\n", option.name, option.what, option.initial, option.least, option.most);
  }
  return text;
}

Result<std::vector<DeviceChoice>> read_devices(std::span<const std::string> texts, std::span<const ListedDevice> devices) {
  std::vector<DeviceChoice> choices;
  for (const std::string& text : texts) {
    auto choice = read_device(text, devices);
    if (!choice) return choice.error();
    if (find_named(std::span<const DeviceChoice>(choices), choice->name) != nullptr)
      return base::usage_error(fmt::format("--device: found {} twice, expected it once", choice->name));
    choices.push_back(std::move(*choice));
  }
  return choices;
}

std::string device_text(const DeviceChoice& choice) {
  std::string text(choice.name);
  for (const core::Setting& setting : choice.settings) text += fmt::format(",{}={}", setting.name, setting.value);
  return text;
}

std::string counts_text(std::span<const core::Count> counts) {
  std::string text;
  for (const core::Count& count : counts) {
    if (count.value == 0) continue;
    std::string name(count.name);
    std::replace(name.begin(), name.end(), '_', ' ');
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, count.value);
  }
  return text.empty() ? "nothing" : text;
}

base::Json counts_json(std::span<const core::Count> counts) {
  base::Json json = base::Json::object();
  for (const core::Count& count : counts) json[std::string(count.name)] = count.value;
  return json;
}

}  // namespace sightline::machines
