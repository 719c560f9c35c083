// Plain text in columns, for people: a row is one line, its cells padded to the widths of their columns.
//
// A column has the same width in every table of a command, so that tables below each other line up and
// scripts that cut columns keep working. A cell longer than its column moves the rest of its own row only.
// Blanks at the end of a line are left out.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sightline::base {

class TextTable {
 public:
  // Positive: that many characters, the text at the right. Negative: the text at the left. 0: as it is.
  explicit TextTable(std::vector<int> widths) : widths_(std::move(widths)) {}

  // At most as many cells as there are columns.
  void row(std::initializer_list<std::string_view> cells);
  void row(const std::vector<std::string>& cells);
  // A line that is not in columns, without its end.
  void line(std::string_view text);

  [[nodiscard]] std::string text() const;
  // The same, if its rows are not longer than `width` characters. Else columns are as narrow as their cells, and as many of those
  // `least` as need be are left out, the first of them first; a last line says which, by the cells of the first row.
  [[nodiscard]] std::string text_within(std::size_t width, const std::vector<std::size_t>& least) const;

 private:
  struct Line {
    std::vector<std::string> cells;  // empty: the text
    std::string text;
  };
  std::vector<int> widths_;
  std::vector<Line> lines_;
};

}  // namespace sightline::base
