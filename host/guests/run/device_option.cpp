// See device_option.hpp.
#include "host/guests/run/device_option.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "host/base/number.hpp"

namespace sightline::guests::run {

namespace {

// Takes the text before the next comma, and the comma.
std::string take_part(std::string_view& text) {
  const std::size_t comma = std::min(text.find(','), text.size());
  const std::string part(text.substr(0, comma));
  text.remove_prefix(std::min(comma + 1, text.size()));
  return part;
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
    for (const core::DeviceOption& setting : device.settings)
      text += fmt::format("    {:<18} {}: {} ({} to {})\n", setting.name, setting.what, setting.initial, setting.least, setting.most);
  }
  return text;
}

Result<std::vector<DeviceChoice>> read_devices(std::span<const std::string> texts) {
  std::vector<DeviceChoice> choices;
  for (const std::string& text : texts) {
    std::string_view left = text;
    DeviceChoice choice{text, take_part(left), {}};
    while (!left.empty()) {
      const std::string setting = take_part(left);
      const std::size_t equals = setting.find('=');
      const auto value = base::whole_number<std::int64_t>(equals == std::string::npos ? "" : setting.substr(equals + 1), 10);
      if (!value) return usage(fmt::format("--device {}: found \"{}\", expected SETTING=N, N in decimal", choice.name, setting));
      choice.values.emplace_back(setting.substr(0, equals), *value);
    }
    choices.push_back(std::move(choice));
  }
  return choices;
}

std::string counts_text(std::span<const core::Count> counts) {
  std::string text;
  for (const core::Count& count : counts) {
    std::string name(count.name);
    std::replace(name.begin(), name.end(), '_', ' ');
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count.value, name);
  }
  return text.empty() ? "nothing counted" : text;
}

base::Json counts_json(std::span<const core::Count> counts) {
  base::Json json = base::Json::object();
  for (const core::Count& count : counts) json[std::string(count.name)] = count.value;
  return json;
}

}  // namespace sightline::guests::run
