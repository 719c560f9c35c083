// A grid file as words between blanks, whatever its lines are: ASCII grids of ESRI and of Surfer.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"

namespace sightline::scene {

struct GridWord {
  std::string_view text;  // empty: the file ends
  std::size_t line = 1;
  std::size_t column = 1;
};

// The first error stays; whatever is read after it is 0.
class GridWords {
 public:
  GridWords(std::string_view text, std::string_view source) : text_(text), source_(source) {}

  [[nodiscard]] const std::optional<base::Error>& error() const { return error_; }

  GridWord next();
  [[nodiscard]] std::string_view peek() const;
  // Is the next word nan, with a sign or without one?
  [[nodiscard]] bool at_nan() const;
  bool take_nan();

  // `what` is named in errors.
  double number(const std::string& what);
  std::size_t count(const std::string& what, std::size_t least, std::size_t most);
  // All heights that are left, `count` of them; NaN where `is_hole` says so, and for a word nan.
  template <class IsHole>
  std::vector<double> heights(std::size_t count, const IsHole& is_hole) {
    std::vector<double> values;
    while (values.size() < count && !error_) {
      const double value = height();
      values.push_back(is_hole(value) ? no_height : value);
    }
    expect_end(count);
    return values;
  }
  void fail(const GridWord& word, const std::string& expected, const std::string& remedy = "");

 private:
  static const double no_height;
  double height();
  void expect_end(std::size_t heights);

  std::string_view text_;
  std::string source_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::size_t line_begin_ = 0;
  std::optional<base::Error> error_;
};

}  // namespace sightline::scene
