#include "host/scene/heights/grid_words.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "host/base/number.hpp"
#include "host/base/text.hpp"

namespace sightline::scene {
namespace {

constexpr std::string_view between_words = " \t\r\n";

}  // namespace

const double GridWords::no_height = std::numeric_limits<double>::quiet_NaN();

GridWord GridWords::next() {
  for (; at_ < text_.size() && between_words.find(text_[at_]) != std::string_view::npos; ++at_) {
    if (text_[at_] != '\n') continue;
    ++line_;
    line_begin_ = at_ + 1;
  }
  const std::size_t begin = at_;
  at_ = std::min(text_.find_first_of(between_words, begin), text_.size());
  return {text_.substr(begin, at_ - begin), line_, begin - line_begin_ + 1};
}

std::string_view GridWords::peek() const {
  const std::size_t begin = std::min(text_.find_first_not_of(between_words, at_), text_.size());
  return text_.substr(begin, std::min(text_.find_first_of(between_words, begin), text_.size()) - begin);
}

bool GridWords::at_nan() const {
  const std::string_view word = peek();
  if (word.size() < 3 || word.size() > 4) return false;
  const std::string small = base::lower_case(word);
  return small == "nan" || small == "-nan" || small == "+nan";
}

bool GridWords::take_nan() {
  if (!at_nan()) return false;
  static_cast<void>(next());
  return true;
}

double GridWords::number(const std::string& what) {
  if (error_) return 0;
  const GridWord word = next();
  const auto value = base::decimal_number(word.text);
  if (!value) fail(word, what);
  return value.value_or(0);
}

std::size_t GridWords::count(const std::string& what, std::size_t least, std::size_t most) {
  if (error_) return 0;
  const GridWord word = next();
  const auto value = base::whole_number<std::size_t>(word.text, 10, least, most);
  if (!value) fail(word, what + " from " + std::to_string(least) + " to " + std::to_string(most));
  return value.value_or(0);
}

double GridWords::height() {
  if (take_nan()) return no_height;
  const GridWord word = next();
  const auto value = base::decimal_number(word.text);
  if (!value) fail(word, "a height");
  return value.value_or(0);
}

void GridWords::expect_end(std::size_t heights) {
  const GridWord word = next();
  if (!word.text.empty())
    fail(word, "the end of the file after " + std::to_string(heights) + " heights",
         "correct the numbers of columns and rows in the header");
}

void GridWords::fail(const GridWord& word, const std::string& expected, const std::string& remedy) {
  if (error_) return;
  constexpr std::size_t most = 24;
  std::string found = word.text.empty() ? "the end of the file" : "'";
  for (const char c : word.text.substr(0, most)) found += c >= ' ' && c <= '~' ? c : '?';
  if (!word.text.empty()) found += word.text.size() > most ? "...'" : "'";
  error_ =
      base::Error{source_, std::to_string(word.line) + ":" + std::to_string(word.column), std::move(found), expected, remedy};
}

}  // namespace sightline::scene
