#include "host/live/dap/places.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>

#include "host/base/number.hpp"
#include "host/base/text.hpp"
#include "host/live/dap/messages.hpp"

namespace sightline::live::dap {

std::string reference(std::uint32_t at) {
  return fmt::format("0x{:X}", at);
}

std::uint32_t bytes_a_word(const Debugger& debugger) {
  return debugger.description().word_bits > 8 ? 4 : 1;
}

std::int64_t byte_place_of(const Debugger& debugger, std::string_view text, std::int64_t offset) {
  std::optional<std::uint64_t> at;
  if (text.starts_with("0x") || text.starts_with("0X")) at = base::unsigned_number(text.substr(2), 16);
  if (!at) at = base::count_number(text);
  const std::int64_t words = debugger.machine().words();
  const std::int64_t a_word = bytes_a_word(debugger);
  constexpr std::int64_t farthest = std::int64_t{1} << 40;  // outside memory; the sum does not overflow
  const std::int64_t place =
      at && *at < (std::uint64_t{1} << 32) ? static_cast<std::int64_t>(*at) * a_word + std::clamp(offset, -farthest, farthest) : -1;
  if (place < 0 || place >= words * a_word) {
    throw base::usage_error(fmt::format("found {} and {} bytes, expected an address in {}, 0x0 to 0x{:X}", text, offset,
                              debugger.description().memory_name, words - 1));
  }
  return place;
}

std::uint32_t place_of(const Debugger& debugger, std::string_view text, std::int64_t offset) {
  return static_cast<std::uint32_t>(byte_place_of(debugger, text, offset) / bytes_a_word(debugger));
}

std::string_view word_in_brackets(std::string_view text) {
  text = base::without_blanks(text);
  if (text.empty() || text.front() != '[') return {};
  int depth = 0;
  for (std::size_t n = 0; n < text.size(); ++n) {
    if (text[n] == '[') ++depth;
    if (text[n] == ']' && --depth == 0) return n + 1 == text.size() ? text.substr(1, n - 1) : std::string_view();
  }
  return {};
}

base::Json source_of(const std::string& file) {
  std::error_code ignored;
  const std::filesystem::path path = std::filesystem::absolute(file, ignored);
  return base::Json{{"name", path.filename().string()}, {"path", path.string()}};
}

std::vector<std::string> source_files(const Symbols& symbols) {
  std::vector<std::string> files;
  for (const auto& [place, at] : symbols.lines())
    if (files.empty() || files.back() != place.file) files.push_back(place.file);
  return files;
}

std::vector<CodeLine> code_lines(const Symbols& symbols, const std::string& file, std::int64_t first, std::int64_t last) {
  std::map<std::size_t, std::uint32_t> found;  // by line: several names may mean one file
  for (const std::string& name : source_files(symbols)) {
    if (!same_file(name, file)) continue;
    const auto begin = symbols.lines().lower_bound({name, static_cast<std::size_t>(std::max<std::int64_t>(first, 0))});
    for (auto line = begin; line != symbols.lines().end() && line->first.file == name; ++line) {
      if (static_cast<std::int64_t>(line->first.line) > last) break;
      found.emplace(line->first.line, line->second);
    }
  }
  std::vector<CodeLine> lines;
  for (const auto& [line, at] : found) lines.push_back({line, at});
  return lines;
}

bool same_file(const std::string& a, const std::string& b) {
  std::error_code ignored;
  return a == b || std::filesystem::weakly_canonical(a, ignored) == std::filesystem::weakly_canonical(b, ignored);
}

}  // namespace sightline::live::dap
