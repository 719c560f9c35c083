// See poly_text.hpp.
#include "host/scene/read/poly_text.hpp"

#include <algorithm>
#include <limits>

#include "host/base/number.hpp"
#include "host/base/result.hpp"
#include "host/base/text.hpp"

namespace sightline::scene {
namespace {

constexpr bool is_blank(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

// Where a comment begins: not within 1.#QNAN, as some programs write what is no number.
std::size_t comment_in(std::string_view line) {
  std::size_t at = line.find('#');
  while (at != std::string_view::npos && at >= 2 && line.substr(at - 2, 2) == "1." && at + 1 < line.size() &&
         std::string_view("IQSiqs").find(line[at + 1]) != std::string_view::npos)
    at = line.find('#', at + 1);
  return at;
}

}  // namespace

bool PolyLines::next() {
  fields_.clear();
  taken_ = 0;
  while (at_ < text_.size()) {
    number_ = next_number_;
    bool continues = true;
    while (continues && at_ < text_.size()) {
      if (newline_ <= at_) newline_ = std::min(text_.find('\n', at_), text_.size());
      std::string_view line = text_.substr(at_, newline_ - at_);
      if (const std::size_t end = line.find('\r'); end != std::string_view::npos && end + 1 < line.size())
        line = line.substr(0, end);
      at_ += line.size() + 1;
      continues = split(line);
      ++next_number_;
    }
    if (!fields_.empty()) return true;
  }
  number_ = 0;
  return false;
}

bool PolyLines::split(std::string_view line) {
  line = line.substr(0, comment_in(line));
  for (std::size_t at = 0; at < line.size(); ++at) {
    if (is_blank(line[at])) continue;
    const std::size_t begin = at;
    while (at < line.size() && !is_blank(line[at])) ++at;
    fields_.push_back(line.substr(begin, at - begin));
  }
  if (line.empty() || fields_.empty() || !fields_.back().ends_with('\\')) return false;
  fields_.back().remove_suffix(1);
  if (fields_.back().empty()) fields_.pop_back();
  return true;
}

base::Error PolyLines::error(const std::string& cause) const {
  return {source_, number_ == 0 ? "end of file" : "line " + std::to_string(number_), cause};
}

base::Error PolyLines::unexpected(std::string_view found, const std::string& expected) const {
  return error("found " + (found.empty() ? "the end of the file" : quoted_excerpt(found)) + ", expected " + expected);
}

std::optional<double> coordinate_of(std::string_view field) {
  if (const auto number = base::decimal_number(field)) return number;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (field.starts_with('-') || field.starts_with('+')) field.remove_prefix(1);
  const std::string word = base::lower_case(field);
  for (const std::string_view spelling : {"nan", "inf", "infinity"})
    if (word == spelling) return none;
  for (const std::string_view beginning : {"nan(", "1.#ind", "1.#inf", "1.#qnan", "1.#snan"})
    if (std::string_view(word).starts_with(beginning)) return none;
  // A decimal number that is too large.
  const std::size_t e = word.find('e');
  if (e == std::string::npos || !base::decimal_number(field.substr(0, e))) return std::nullopt;
  std::string_view exponent = field.substr(e + 1);
  if (exponent.starts_with('+')) exponent.remove_prefix(1);
  return base::unsigned_number(exponent) ? std::optional(none) : std::nullopt;
}

std::string printable_name(std::string text) {
  constexpr std::size_t longest = 200;
  if (text.size() > longest) text.resize(longest);
  for (char& c : text) c = c >= ' ' && c <= '~' ? c : '?';
  return text;
}

std::string quoted_excerpt(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string result = "\"";
  for (const char c : text.substr(0, longest)) result += c >= ' ' && c <= '~' ? c : '?';
  return result + (text.size() > longest ? "...\"" : "\"");
}

}  // namespace sightline::scene
