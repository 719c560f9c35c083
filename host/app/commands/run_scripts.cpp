// See run_scripts.hpp.
#include "host/app/commands/run_scripts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>

#include "host/app/command.hpp"
#include "host/base/number.hpp"

namespace sightline::app {

namespace {

constexpr std::string_view blanks = " \t\r";
constexpr std::string_view seconds_expected = "a decimal number of seconds from 0 to 9000000000";

std::optional<core::Instant> parse_seconds(std::string_view text) {
  const auto seconds = base::fixed_number(text, 0, 9e9);
  if (!seconds) return std::nullopt;
  return core::at_nanoseconds(std::llround(*seconds * 1e9));
}

std::optional<std::uint32_t> parse_octal(std::string_view text, std::uint32_t most) {
  return base::whole_number<std::uint32_t>(text, 8, 0, most);
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// The field of view that `X Y [RADIUS]` means; nothing if it means none.
std::optional<type340::LightPen> parse_field_of_view(std::string_view text) {
  static constexpr std::uint32_t last_point = type340::Registers::screen_mask;
  constexpr std::uint32_t usual_radius = 4;
  std::array<std::uint32_t, 3> numbers{0, 0, usual_radius};
  std::size_t count = 0;
  for (; !text.empty(); text = trimmed(text)) {
    const std::size_t length = std::min(text.find_first_of(blanks), text.size());
    if (count == numbers.size()) return std::nullopt;
    const auto number = base::whole_number<std::uint32_t>(text.substr(0, length), 10, 0, last_point);
    if (!number) return std::nullopt;
    numbers[count++] = *number;
    text.remove_prefix(length);
  }
  if (count < 2) return std::nullopt;
  const auto [x, y, radius] = numbers;
  const auto low = [r = radius](std::uint32_t at) {
    return static_cast<std::uint16_t>(at - std::min(at, r));
  };
  const auto high = [r = radius](std::uint32_t at) {
    return static_cast<std::uint16_t>(std::min(at + r, last_point));
  };
  type340::LightPen pen;
  pen.left = low(x);
  pen.bottom = low(y);
  pen.right = high(x);
  pen.top = high(y);
  return pen;
}

[[noreturn]] void script_failure(const std::string& file, std::size_t line, std::string_view found,
                                 std::string_view expected) {
  throw Failure(ExitCode::bad_input,
                fmt::format("{}:{}: error: found \"{}\", expected {}", file, line, found, expected));
}

void check_order(const std::string& file, std::size_t line, core::Instant last, core::Instant when) {
  if (when < last)
    script_failure(file, line, "a time before the one of the line above", "lines in order of time");
}

// Calls take(line number, instant, what) for every line of the script.
template <class Take>
void each_line(std::string_view text, const std::string& file, Take take) {
  std::size_t number = 0;
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
    const auto when = parse_seconds(line.substr(0, split));
    if (!when) script_failure(file, number, line.substr(0, split), seconds_expected);
    take(number, *when, split < line.size() ? line.substr(split + 1) : std::string_view());
  }
}

// One key of `typed`, which begins after it then; nothing if an escape is none of ours.
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
  const auto code = parse_octal(typed.substr(0, 3), 0177);
  if (!code || typed.size() < 3) return std::nullopt;
  typed.remove_prefix(3);
  return static_cast<std::uint8_t>(*code);
}

}  // namespace

void set_register(harness::RegisterSettings& registers, const std::string& text, std::uint32_t core_words) {
  const std::size_t equals = text.find('=');
  std::string name = text.substr(0, equals);
  std::transform(name.begin(), name.end(), name.begin(),
                 [](char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); });
  const auto value = [&](std::uint32_t most, std::string_view what) {
    return octal_argument("--set " + name, equals == std::string::npos ? "" : text.substr(equals + 1), most,
                          what);
  };
  constexpr std::uint32_t word = core::Word18::mask;
  if (name == "PC") {
    registers.pc = value(core_words - 1, "an address in core");
  } else if (name == "AC") {
    registers.ac = core::Word18(value(word, "a word"));
  } else if (name == "L") {
    registers.link = value(1, "a bit") != 0;
  } else if (name == "MQ") {
    registers.mq = core::Word18(value(word, "a word"));
  } else if (name == "SC") {
    registers.sc = core::Word<6>(value(core::Word<6>::mask, "a step count"));
  } else if (name == "SR") {
    registers.switches = core::Word18(value(word, "a word"));
  } else if (name == "ION") {
    registers.interrupts_on = value(1, "a bit") != 0;
  } else {
    throw Failure(
        ExitCode::usage,
        fmt::format("--set: found \"{}\", expected REGISTER=VALUE with one of PC AC L MQ SC SR ION", text));
  }
}

core::Instant seconds_argument(std::string_view option, std::string_view text) {
  const auto seconds = parse_seconds(text);
  if (seconds) return *seconds;
  throw Failure(ExitCode::usage,
                fmt::format("{}: found \"{}\", expected {}", option, text, seconds_expected));
}

std::uint64_t count_argument(std::string_view option, std::string_view text) {
  if (const auto value = base::unsigned_number(text)) return *value;
  throw Failure(ExitCode::usage,
                fmt::format("{}: found \"{}\", expected a whole decimal number", option, text));
}

std::vector<pdp7::SwitchSetting> read_switch_script(std::string_view text, const std::string& file) {
  std::vector<pdp7::SwitchSetting> settings;
  each_line(text, file, [&](std::size_t line, core::Instant when, std::string_view what) {
    const std::string_view octal = trimmed(what.substr(0, what.find('#')));
    const auto value = parse_octal(octal, core::Word18::mask);
    if (!value) script_failure(file, line, octal, "the switches in octal, 0 to 777777");
    settings.push_back({when, core::Word18(*value)});
  });
  return settings;
}

std::vector<harness::KeyPress> read_keyboard_script(std::string_view text, const std::string& file) {
  std::vector<harness::KeyPress> keys;
  core::Instant last{};
  each_line(text, file, [&](std::size_t line, core::Instant when, std::string_view typed) {
    check_order(file, line, last, when);
    last = when;
    while (!typed.empty()) {
      const std::string_view rest = typed;
      const auto key = take_key(typed);
      if (!key)
        script_failure(file, line, rest.substr(0, 4),
                       "\\r, \\n, \\t, \\\\ or \\ and three octal digits up to 177");
      keys.push_back({when, *key});
    }
  });
  return keys;
}

std::vector<harness::PenMove> read_light_pen_script(std::string_view text, const std::string& file) {
  std::vector<harness::PenMove> moves;
  core::Instant last{};
  each_line(text, file, [&](std::size_t line, core::Instant when, std::string_view what) {
    check_order(file, line, last, when);
    last = when;
    const std::string_view where = trimmed(what.substr(0, what.find('#')));
    const auto pen = parse_field_of_view(where);
    if (!pen && where != "off")
      script_failure(file, line, where, "off, or X Y and perhaps RADIUS, decimal points from 0 to 1023");
    moves.push_back({when, pen});
  });
  return moves;
}

}  // namespace sightline::app
