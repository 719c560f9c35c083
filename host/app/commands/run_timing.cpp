// See run_timing.hpp.
#include "host/app/commands/run_timing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>

#include "host/app/command.hpp"
#include "host/base/number.hpp"

namespace sightline::app {

namespace {

// One member of pdp7::Timing. `device` counts only for iot_stretch.
struct TimingName {
  std::string_view name;
  std::string_view unit;
  std::int64_t least;
  std::int64_t most;
  std::int64_t (*get)(const pdp7::Timing& timing, std::size_t device);
  void (*set)(pdp7::Timing& timing, std::size_t device, std::int64_t value);
};

template <core::Duration pdp7::Timing::*Member>
constexpr TimingName time_named(std::string_view name, std::int64_t least, std::int64_t most) {
  return {name,
          "ns",
          least,
          most,
          [](const pdp7::Timing& t, std::size_t) { return (t.*Member).count(); },
          [](pdp7::Timing& t, std::size_t, std::int64_t value) { t.*Member = core::Duration(value); }};
}

template <auto Member>
constexpr TimingName number_named(std::string_view name, std::string_view unit, std::int64_t most) {
  return {name,
          unit,
          1,
          most,
          [](const pdp7::Timing& t, std::size_t) { return static_cast<std::int64_t>(t.*Member); },
          [](pdp7::Timing& t, std::size_t, std::int64_t value) {
            t.*Member = static_cast<std::remove_reference_t<decltype(t.*Member)>>(value);
          }};
}

constexpr std::string_view stretch_prefix = "iot_stretch.";
constexpr std::int64_t longest_step = 10'000;
constexpr std::int64_t longest_stretch = 100'000;
constexpr std::int64_t longest_line = 1'000'000'000;

using pdp7::Timing;
constexpr std::array timing_names{
    time_named<&Timing::eae_setup>("eae_setup", 0, longest_step),
    time_named<&Timing::eae_shift_step>("eae_shift_step", 0, longest_step),
    time_named<&Timing::eae_normalize_step>("eae_normalize_step", 0, longest_step),
    time_named<&Timing::eae_multiply_step>("eae_multiply_step", 0, longest_step),
    time_named<&Timing::eae_divide_step>("eae_divide_step", 0, longest_step),
    number_named<&Timing::interrupt_cycles>("interrupt_cycles", "cycles", 100),
    number_named<&Timing::clock_tick_cycles>("clock_tick_cycles", "cycles", 100),
    number_named<&Timing::clock_hertz>("clock_hertz", "Hz", 400),
    time_named<&Timing::reader_line>("reader_line", 1, longest_line),
    time_named<&Timing::punch_line>("punch_line", 1, longest_line),
    time_named<&Timing::teletype_character>("teletype_character", 1, longest_line),
    TimingName{"iot_stretch.DD", "ns", 0, longest_stretch,
               [](const Timing& t, std::size_t device) { return t.iot_stretch[device].count(); },
               [](Timing& t, std::size_t device, std::int64_t value) {
                 t.iot_stretch[device] = core::Duration(value);
               }},
};

struct Place {
  const TimingName* member;
  std::size_t device;
};

// Devices are written in two octal digits, so that each has one name.
std::optional<Place> place_of(std::string_view name) {
  if (name.substr(0, stretch_prefix.size()) == stretch_prefix) {
    const std::string_view digits = name.substr(stretch_prefix.size());
    const auto device = base::whole_number<std::uint8_t>(digits, 8);
    if (digits.size() != 2 || !device || *device >= Timing{}.iot_stretch.size()) return std::nullopt;
    return Place{&timing_names.back(), *device};
  }
  const auto found = std::find_if(timing_names.begin(), timing_names.end() - 1,
                                  [name](const TimingName& row) { return row.name == name; });
  if (found == timing_names.end() - 1) return std::nullopt;
  return Place{&*found, 0};
}

std::string all_names() {
  std::string names;
  for (const TimingName& row : timing_names) names += fmt::format(" {}", row.name);
  return names;
}

TimingSetting timing_setting(const std::string& text) {
  const std::size_t equals = std::min(text.find('='), text.size());
  const std::string name = text.substr(0, equals);
  const auto place = place_of(name);
  if (!place) {
    throw Failure(
        ExitCode::usage,
        fmt::format(
            "--timing: found \"{}\", expected NAME=VALUE with one of{} (DD: a device, two octal digits)",
            text, all_names()));
  }
  const TimingName& row = *place->member;
  const std::string digits = equals < text.size() ? text.substr(equals + 1) : "";
  const auto value = base::whole_number<std::int64_t>(digits, 10);
  if (value && row.least <= *value && *value <= row.most) return {name, *value};
  throw Failure(ExitCode::usage,
                fmt::format("--timing {}: found \"{}\", expected a whole decimal number, {} to {} ({})", name,
                            digits, row.least, row.most, row.unit));
}

}  // namespace

std::vector<TimingSetting> timing_settings(const std::vector<std::string>& texts) {
  std::vector<TimingSetting> settings;
  for (const std::string& text : texts) {
    TimingSetting setting = timing_setting(text);
    const auto same = std::find_if(settings.begin(), settings.end(),
                                   [&setting](const TimingSetting& s) { return s.name == setting.name; });
    if (same == settings.end()) {
      settings.push_back(std::move(setting));
    } else {
      same->value = setting.value;
    }
  }
  return settings;
}

void set_timing(pdp7::Timing& timing, const std::vector<TimingSetting>& settings) {
  for (const TimingSetting& setting : settings) {
    if (const auto place = place_of(setting.name)) place->member->set(timing, place->device, setting.value);
  }
}

std::string timing_help() {
  std::string text;
  for (const TimingName& row : timing_names) {
    text += fmt::format("  {:<20} {:<6}  {} ({} to {})\n", row.name, row.unit, row.get(Timing{}, 0),
                        row.least, row.most);
  }
  return text;
}

}  // namespace sightline::app
