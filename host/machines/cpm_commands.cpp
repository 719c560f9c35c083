// See cpm_commands.hpp.
#include "host/machines/cpm_commands.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "host/base/number.hpp"
#include "host/base/text.hpp"

namespace sightline::machines {

namespace {

constexpr std::size_t longest_command = 127;  // of the CCP's buffer
constexpr char end_of_commands = 0x1A;

// The error's `found`; nullopt: the command is right.
std::optional<std::string> read_command(std::string_view line, CpmCommand& command) {
  command.text = line;
  const std::size_t blank = std::min(line.find(' '), line.size());
  std::string name;
  for (const char c : line.substr(0, blank)) name += static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
  command.tail = line.substr(blank);
  if (name.size() >= 2 && name[1] == ':') {
    if (name[0] < 'A' || name[0] > 'P') return fmt::format("drive {}", name[0]);
    command.drive = static_cast<unsigned>(name[0] - 'A');
    name.erase(0, 2);
    if (name.empty()) return command.tail.find_first_not_of(' ') == std::string::npos ? std::nullopt : std::optional(fmt::format("\"{}\"", line));
  }
  if (name == "USER" && !command.drive) {
    std::string_view rest = command.tail;
    rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
    const auto user = base::whole_number<std::uint8_t>(base::take_word(rest));
    if (!user || *user > 15 || !base::without_blanks(rest).empty()) return fmt::format("\"{}\"", line);
    command.user = *user;
    return std::nullopt;
  }
  if (name.ends_with(".COM")) name.erase(name.size() - 4);
  static constexpr std::string_view never = "=_.:;<>?*,[]|/\\\"";
  const bool fits = !name.empty() && name.size() <= 8 && std::all_of(name.begin(), name.end(), [](char c) {
    return c > ' ' && c < 0x7F && never.find(c) == std::string_view::npos;
  });
  if (!fits) return fmt::format("program \"{}\"", name);
  command.program = std::move(name);
  return std::nullopt;
}

}  // namespace

bool is_built_into_ccp(std::string_view name) {
  constexpr std::array<std::string_view, 5> names{"DIR", "ERA", "REN", "SAVE", "TYPE"};
  return std::find(names.begin(), names.end(), name) != names.end();
}

Result<std::vector<CpmCommand>> read_cpm_commands(const Input& file) {
  std::string_view text(reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size());
  text = text.substr(0, text.find(end_of_commands));
  std::vector<CpmCommand> commands;
  for (std::size_t number = 1; !text.empty(); ++number) {
    std::string_view line = base::take_line(text);
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ' || line.back() == '\t')) line.remove_suffix(1);
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    if (line.empty() || line.front() == ';') continue;
    const auto refused = [&](std::string found, std::string expected) {
      return base::Error{.file = file.name, .place = fmt::format("line {}", number), .found = "found " + found, .expected = std::move(expected)};
    };
    if (line.size() > longest_command)
      return refused(fmt::format("a command of {} characters", line.size()), fmt::format("{} at most: CP/M's command line has no room for more", longest_command));
    if (const auto found = read_command(line, commands.emplace_back()))
      return refused(*found, "PROGRAM ARGUMENTS, X: or USER N, with X of A to P, N of 0 to 15 and a PROGRAM of 1 to 8 characters");
  }
  if (commands.empty()) return base::bad_input(fmt::format("{}: found no command, expected one on each line", file.name));
  return commands;
}

}  // namespace sightline::machines
