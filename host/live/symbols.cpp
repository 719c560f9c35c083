#include "host/live/symbols.hpp"

#include <fmt/core.h>

#include <set>
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

base::Result<base::Done> Symbols::add_table(std::string_view text) {
  std::set<std::string> met;  // keys of this table: a later table replaces a symbol, a later symbol of the same table does not
  for (std::size_t number = 1; !text.empty(); ++number) {
    std::string_view line = take_line(text);
    if (without_blanks(line).empty()) continue;
    const std::string name(take_word(line));
    const auto value = base::unsigned_number(line, radix_);
    if (!value || *value >> 32 != 0) {
      return base::Error{.place = fmt::format("line {}", number),
                         .found = fmt::format("found \"{}\"", without_blanks(line)),
                         .expected = "NAME VALUE, as `sightline asm --symbols` writes them"};
    }
    values_[name] = static_cast<std::uint32_t>(*value);
    std::optional<std::uint32_t>& same = keys_[key(name)];
    const bool first = met.insert(key(name)).second;
    if (first) {
      same = static_cast<std::uint32_t>(*value);
    } else if (same != static_cast<std::uint32_t>(*value)) {
      same.reset();
    }
    by_value_.emplace(static_cast<std::uint32_t>(*value), name);
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
