// Plain text in columns, for people: a row is one line, its cells padded to the widths of their columns.
//
// A column has the same width in every table of a command, so that consecutive tables align and scripts that cut columns
// keep working. A cell longer than its column shifts only the rest of its row. Trailing blanks are removed.
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
  // Positive: that many characters, aligned right. Negative: aligned left. 0: no padding.
  explicit TextTable(std::vector<int> widths) : widths_(std::move(widths)) {}

  // At most as many cells as there are columns.
  void row(std::initializer_list<std::string_view> cells);
  void row(const std::vector<std::string>& cells);
  // A line without columns; `text` has no line end.
  void line(std::string_view text);

  [[nodiscard]] std::string text() const;
  // The same if no row is longer than `width` characters. Otherwise columns are as narrow as their cells, and columns named in
  // `least` are omitted, in that order, until the rows fit; a last line lists the cells of the first row that were omitted.
  [[nodiscard]] std::string text_within(std::size_t width, const std::vector<std::size_t>& least) const;

 private:
  struct Line {
    std::vector<std::string> cells;  // empty: `text` is the line
    std::string text;
  };
  std::vector<int> widths_;
  std::vector<Line> lines_;
};

}  // namespace sightline::base
