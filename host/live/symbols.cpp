#include "host/live/symbols.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>

#include "host/base/number.hpp"
#include "host/base/text.hpp"

namespace sightline::live {

using base::take_line;
using base::take_word;
using base::without_blanks;

std::string Symbols::key(std::string_view name) const {
  constexpr std::size_t significant = 6;
  return base::lower_case(radix_ == 8 ? name.substr(0, significant) : name);
}

namespace {

constexpr std::size_t sym_digits = 4;

bool is_sym_address(std::string_view word) {
  return word.size() == sym_digits &&
         std::all_of(word.begin(), word.end(), [](char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0; });
}

// Bytes of a damaged file, for a message.
std::string printable(std::string_view text) {
  std::string shown(text);
  for (char& c : shown)
    if (c < ' ' || c > '~') c = '?';
  return shown;
}

// No name begins with a digit. Whether FACE is a name or an address depends on what follows.
bool begins_as_sym(std::string_view text) {
  std::string_view rest = without_blanks(text);
  std::string_view line = take_line(rest);
  const std::string_view first = take_word(line);
  if (first.empty()) return false;
  if (std::isdigit(static_cast<unsigned char>(first.front())) != 0) return true;
  return is_sym_address(first) && !base::unsigned_number(line, 16);
}

}  // namespace

void Symbols::add(std::string_view name, std::uint32_t value, std::set<std::string>& met) {
  values_[std::string(name)] = value;
  std::optional<std::uint32_t>& same = keys_[key(name)];
  if (met.insert(key(name)).second) {
    same = value;
  } else if (same != value) {
    same.reset();
  }
  by_value_.emplace(value, name);
}

base::Result<base::Done> Symbols::add_sym(std::string_view text) {
  std::set<std::string> met;
  for (std::size_t number = 1; !text.empty(); ++number) {
    std::string_view line = without_blanks(take_line(text));
    while (!line.empty()) {
      const std::string_view address = take_word(line);
      const std::string_view name = take_word(line);
      const bool is_name = !name.empty() && std::isdigit(static_cast<unsigned char>(name.front())) == 0 &&
                           std::all_of(name.begin(), name.end(), [](char c) { return std::isgraph(static_cast<unsigned char>(c)) != 0; });
      if (!is_sym_address(address) || !is_name) {
        return base::Error{.place = fmt::format("line {}", number),
                           .found = fmt::format("found \"{}{}{}\"", printable(address), name.empty() ? "" : " ", printable(name)),
                           .expected = "an address of four hexadecimal digits and a name, as MAC and LINK write them in a .SYM file"};
      }
      add(name, static_cast<std::uint32_t>(*base::unsigned_number(address, 16)), met);
    }
  }
  return base::Done{};
}

base::Result<base::Done> Symbols::add_table(std::string_view text) {
  constexpr char end_of_file = 0x1A;  // of CP/M
  text = text.substr(0, text.find(end_of_file));
  if (radix_ == 16 && begins_as_sym(text)) return add_sym(text);
  std::set<std::string> met;
  for (std::size_t number = 1; !text.empty(); ++number) {
    std::string_view line = take_line(text);
    if (without_blanks(line).empty()) continue;
    const std::string_view name = take_word(line);
    const auto value = base::unsigned_number(line, radix_);
    if (!value || *value >> 32 != 0) {
      return base::Error{.place = fmt::format("line {}", number),
                         .found = fmt::format("found \"{}\"", printable(without_blanks(line))),
                         .expected = radix_ == 16 ? "NAME VALUE, as `sightline asm --symbols` writes them, or ADDRESS NAME of a .SYM file"
                                                  : "NAME VALUE, as `sightline asm --symbols` writes them"};
    }
    add(name, static_cast<std::uint32_t>(*value), met);
  }
  return base::Done{};
}

void Symbols::add_listing(std::string_view text) {
  while (!text.empty()) {
    std::string_view line = take_line(text);
    if (line.empty() || line.front() == ' ') continue;
    const auto address = base::unsigned_number(take_word(line), radix_);
    const auto code = base::unsigned_number(take_word(line), radix_);
    if (address && code) sources_.emplace(static_cast<std::uint32_t>(*address), line);
  }
}

std::optional<std::uint32_t> Symbols::value(std::string_view name) const {
  const auto found = keys_.find(key(name));
  if (found == keys_.end() || found->second) return found == keys_.end() ? std::nullopt : found->second;
  const auto written = values_.find(name);
  return written == values_.end() ? std::nullopt : std::optional(written->second);
}

std::string Symbols::near(std::uint32_t address) const {
  constexpr std::uint32_t farthest = 0377;
  auto found = by_value_.upper_bound(address);
  while (found != by_value_.begin()) {
    --found;
    if (address - found->first > farthest) return {};
    if (!sources_.empty() && sources_.find(found->first) == sources_.end()) continue;
    const std::uint32_t offset = address - found->first;
    if (offset == 0) return found->second;
    return radix_ == 16 ? fmt::format("{}+{:X}", found->second, offset) : fmt::format("{}+{:o}", found->second, offset);
  }
  return {};
}

std::string_view Symbols::source(std::uint32_t address) const {
  const auto found = sources_.find(address);
  return found == sources_.end() ? std::string_view() : std::string_view(found->second);
}

void Symbols::add_line(std::uint32_t address, Place place) {
  addresses_.emplace(place, address);
  places_.emplace(address, std::move(place));
}

const Symbols::Place* Symbols::place(std::uint32_t address) const {
  const auto found = places_.find(address);
  return found == places_.end() ? nullptr : &found->second;
}

}  // namespace sightline::live
