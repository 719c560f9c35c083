// See poly_text.hpp.
#include "host/scene/read/poly_text.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "host/base/number.hpp"
#include "host/base/result.hpp"
#include "host/base/text.hpp"

namespace sightline::scene {
namespace {

constexpr bool is_blank(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

// Of each character whether it is a blank that ends no line.
constexpr std::array<bool, 256> is_space = [] {
  std::array<bool, 256> result{};
  for (const char c : {' ', '\t', '\v', '\f'}) result[static_cast<unsigned char>(c)] = true;
  return result;
}();

// Of each character whether a field, or what a splitter passes over within one, ends before it.
constexpr std::array<bool, 256> stops = [] {
  std::array<bool, 256> result{};
  for (std::size_t c = 0; c < result.size(); ++c) result[c] = is_blank(static_cast<char>(c)) || c == '#';
  return result;
}();

// Whether a # at `at`, before `end`, begins a comment: not within 1.#QNAN, as some programs write what is no number.
bool begins_comment(const char* line, const char* at, const char* end) {
  const bool behind_one = at - line >= 2 && at[-2] == '1' && at[-1] == '.';
  return !(behind_one && at + 1 < end && std::string_view("IQSiqs").find(at[1]) != std::string_view::npos);
}

}  // namespace

bool PolyLines::next() {
  fields_.clear();
  taken_ = 0;
  while (at_ < text_.size()) {
    number_ = next_number_;
    bool continues = true;
    while (continues && at_ < text_.size()) {
      continues = split_line();
      ++next_number_;
    }
    if (!fields_.empty()) return true;
  }
  number_ = 0;
  return false;
}

bool PolyLines::split_line() {
  const char* const line = text_.data() + at_;
  const char* const end = text_.data() + text_.size();
  // An LF ends the line, and so does a CR that is not before one.
  const auto ends_line = [end](const char* c) { return c == end || *c == '\n' || (*c == '\r' && c + 1 != end && c[1] != '\n'); };
  const char* at = line;
  bool comment = false;
  while (!comment) {
    while (at != end && is_space[static_cast<unsigned char>(*at)]) ++at;
    if (ends_line(at)) break;
    if (*at == '\r') {  // of CRLF, or the last character
      ++at;
      continue;
    }
    const char* const begin = at;
    while (true) {
      while (at != end && !stops[static_cast<unsigned char>(*at)]) ++at;
      if (at == end || *at != '#') break;
      comment = begins_comment(line, at, end);
      if (comment) break;
      ++at;
    }
    if (at != begin) fields_.emplace_back(begin, static_cast<std::size_t>(at - begin));
  }
  const bool empty = at == line;
  while (!ends_line(at)) ++at;
  at_ = static_cast<std::size_t>(at - text_.data()) + 1;
  if (empty || fields_.empty() || !fields_.back().ends_with('\\')) return false;
  fields_.back().remove_suffix(1);
  if (fields_.back().empty()) fields_.pop_back();
  return true;
}

std::vector<std::string_view> PolyLines::parts(std::size_t count) const {
  const std::string_view text = text_.substr(std::min(at_, text_.size()));
  // Where a line begins, and the one before it is not continued.
  const auto find_line = [text](std::size_t from) {
    while (true) {
      const std::size_t end = text.find('\n', from);
      if (end == std::string_view::npos) return text.size();
      const std::size_t begin = text.substr(0, end).find_last_of("\r\n") + 1;  // npos + 1 is 0
      if (text.substr(begin, end - begin).find('\\') == std::string_view::npos) return end + 1;
      from = end + 1;
    }
  };
  std::vector<std::string_view> result;
  std::size_t begin = 0;
  for (std::size_t part = 0; part < count; ++part) {
    const std::size_t end = part + 1 == count ? text.size() : find_line(std::max(begin, text.size() / count * (part + 1)));
    result.push_back(text.substr(begin, end - begin));
    begin = end;
  }
  return result;
}

base::Error PolyLines::error(const std::string& cause) const {
  return {source_, number_ == 0 ? "end of file" : "line " + std::to_string(number_), cause};
}

base::Error PolyLines::unexpected(std::string_view found, const std::string& expected) const {
  return error("found " + (found.empty() ? "the end of the file" : quoted_excerpt(found)) + ", expected " + expected);
}

std::size_t count_lines(std::string_view text) {
  std::size_t count = 0;
  if (text.find('\\') != std::string_view::npos || text.find('\r') != std::string_view::npos) {
    PolyLines lines(text, {});
    while (lines.next()) ++count;
    return count;
  }
  // No line is continued, and each ends with LF: it need not be split.
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::size_t first = 0;
    while (first < end && is_blank(text[first])) ++first;
    if (first < end && text[first] != '#') ++count;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return count;
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
