// See pdp7_scripts.hpp.
#include "host/machines/pdp7_scripts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "emulators/type340/registers.hpp"
#include "host/base/number.hpp"

namespace sightline::machines {

namespace {

constexpr std::string_view blanks = " \t\r";

std::string_view trim(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string_view without_comment(std::string_view text) {
  return trim(text.substr(0, text.find('#')));
}

struct ScriptLine {
  const Input& script;
  std::size_t number;
  core::Instant when;
  std::string_view what;

  [[nodiscard]] base::Error error(std::string_view found, std::string_view expected) const {
    return base::bad_input(
        fmt::format("{}:{}: error: found \"{}\", expected {}", script.name, number, found, expected));
  }
};

// Calls take(ScriptLine) for every line; its first error ends the reading. `ordered`: times must not decrease.
template <class Take>
Result<Done> each_line(const Input& script, bool ordered, Take take) {
  std::string_view text(reinterpret_cast<const char*>(script.bytes.data()), script.bytes.size());
  std::size_t number = 0;
  core::Instant last{};
  while (!text.empty()) {
    ++number;
    const std::size_t length = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, length);
    text.remove_prefix(std::min(length + 1, text.size()));
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    const std::size_t first = line.find_first_not_of(blanks);
    if (first == std::string_view::npos || line[first] == '#') continue;
    line.remove_prefix(first);
    const std::size_t split = std::min(line.find_first_of(blanks), line.size());
    ScriptLine read{script, number, {}, split < line.size() ? line.substr(split + 1) : std::string_view()};
    const auto when = parse_seconds(line.substr(0, split));
    if (!when) return read.error(line.substr(0, split), seconds_expected);
    read.when = *when;
    if (ordered && *when < last)
      return read.error("a time before the one of the line above", "lines in order of time");
    last = *when;
    if (auto done = take(read); !done) return done;
  }
  return Done{};
}

// Removes and returns the first key of `typed`; nullopt if the escape is unknown.
std::optional<std::uint8_t> take_key(std::string_view& typed) {
  const char first = typed.front();
  typed.remove_prefix(1);
  if (first != '\\') return static_cast<std::uint8_t>(static_cast<unsigned char>(first) & 0177U);
  if (typed.empty()) return std::nullopt;
  constexpr std::string_view names = "rnt\\";
  constexpr std::string_view codes = "\r\n\t\\";
  if (const std::size_t which = names.find(typed.front()); which != std::string_view::npos) {
    typed.remove_prefix(1);
    return static_cast<std::uint8_t>(codes[which]);
  }
  const auto code = base::whole_number<std::uint8_t>(typed.substr(0, 3), 8);
  if (!code || *code > 0177 || typed.size() < 3) return std::nullopt;
  typed.remove_prefix(3);
  return code;
}

// Parses `X Y [RADIUS]`; nullopt if it is malformed.
std::optional<type340::LightPen> parse_field_of_view(std::string_view text) {
  static constexpr std::uint32_t last_point = type340::Registers::screen_mask;
  constexpr std::uint32_t usual_radius = 4;
  std::array<std::uint32_t, 3> numbers{0, 0, usual_radius};
  std::size_t count = 0;
  for (; !text.empty(); text = trim(text)) {
    const std::size_t length = std::min(text.find_first_of(blanks), text.size());
    const auto number = base::whole_number<std::uint32_t>(text.substr(0, length), 10);
    if (count == numbers.size() || !number || *number > last_point) return std::nullopt;
    numbers[count++] = *number;
    text.remove_prefix(length);
  }
  if (count < 2) return std::nullopt;
  const std::uint32_t radius = numbers[2];
  const auto low = [radius](std::uint32_t at) {
    return static_cast<std::uint16_t>(at - std::min(at, radius));
  };
  const auto high = [radius](std::uint32_t at) {
    return static_cast<std::uint16_t>(std::min(at + radius, last_point));
  };
  type340::LightPen pen;
  pen.left = low(numbers[0]);
  pen.bottom = low(numbers[1]);
  pen.right = high(numbers[0]);
  pen.top = high(numbers[1]);
  return pen;
}

}  // namespace

std::optional<core::Instant> parse_seconds(std::string_view text) {
  const auto seconds = base::fixed_number(text, 0, 9e9);
  if (!seconds) return std::nullopt;
  return core::at_nanoseconds(std::llround(*seconds * 1e9));
}

Result<Done> read_switches(const Input& script, std::vector<pdp7::SwitchSetting>& settings) {
  return each_line(script, false, [&settings](const ScriptLine& line) -> Result<Done> {
    const std::string_view octal = without_comment(line.what);
    const auto value = base::whole_number<std::uint32_t>(octal, 8);
    if (!value || *value > core::Word18::mask) return line.error(octal, "the switches in octal, 0 to 777777");
    settings.push_back({line.when, core::Word18(*value)});
    return Done{};
  });
}

Result<Done> read_keyboard(const Input& script, std::vector<KeyPress>& keys) {
  return each_line(script, true, [&keys](const ScriptLine& line) -> Result<Done> {
    std::string_view typed = line.what;
    while (!typed.empty()) {
      const std::string_view rest = typed;
      const auto key = take_key(typed);
      if (!key)
        return line.error(rest.substr(0, 4), "\\r, \\n, \\t, \\\\ or \\ and three octal digits up to 177");
      keys.push_back({line.when, *key});
    }
    return Done{};
  });
}

Result<Done> read_light_pen(const Input& script, std::vector<PenMove>& moves) {
  return each_line(script, true, [&moves](const ScriptLine& line) -> Result<Done> {
    const std::string_view where = without_comment(line.what);
    const auto pen = parse_field_of_view(where);
    if (!pen && where != "off")
      return line.error(where, "off, or X Y and perhaps RADIUS, decimal points from 0 to 1023");
    moves.push_back({line.when, pen});
    return Done{};
  });
}

}  // namespace sightline::machines
