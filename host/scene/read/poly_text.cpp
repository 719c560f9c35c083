// See poly_text.hpp.
#include "host/scene/read/poly_text.hpp"

#include <algorithm>

#include "host/base/result.hpp"

namespace sightline::scene {

bool PolyLines::next() {
  fields_.clear();
  while (!text_.empty()) {
    number_ = next_number_;
    bool continues = true;
    while (continues && !text_.empty()) {
      const std::size_t end = text_.find('\n');
      continues = split(text_.substr(0, end));
      text_.remove_prefix(end == std::string_view::npos ? text_.size() : end + 1);
      ++next_number_;
    }
    if (!fields_.empty()) return true;
  }
  number_ = 0;
  return false;
}

bool PolyLines::split(std::string_view line) {
  line = line.substr(0, line.find('#'));
  constexpr std::string_view blanks = " \t\r\v\f";
  std::size_t at = line.find_first_not_of(blanks);
  while (at != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
    const std::string_view field = line.substr(at, end - at);
    at = line.find_first_not_of(blanks, end);
    if (field == "\\" && at == std::string_view::npos) return true;
    fields_.push_back(field);
  }
  return false;
}

base::Error PolyLines::error(const std::string& cause) const {
  return {source_, number_ == 0 ? "end of file" : "line " + std::to_string(number_), cause};
}

base::Error PolyLines::unexpected(std::string_view found, const std::string& expected) const {
  return error("found " + quoted_excerpt(found) + ", expected " + expected);
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
