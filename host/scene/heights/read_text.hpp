// A text of numbers as lines of fields, whatever their layout is.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::scene {

struct HeightField {
  double value = 0;        // NaN if the field is missing
  std::size_t column = 1;  // from 1
};

struct HeightLine {
  std::vector<HeightField> fields;
  std::size_t number = 1;    // in the file, from 1
  std::size_t end = 1;       // the column after its last character
  bool after_blank = false;  // blank lines precede it, other than at the start of the file
};

// The first line, if it is not a line of numbers.
struct HeightHeading {
  std::vector<std::string> names;  // of the columns; of a table the name of the corner only
  HeightLine line;                 // NaN for a name
  bool table = false;              // numbers follow the corner: places along x; every other line begins with a place along z
};

struct HeightText {
  HeightHeading heading;          // without names and fields: none
  std::vector<HeightLine> lines;  // at least one; none empty
  // Fields that are neither numbers nor missing, read as NaN: the first one of each column, in the order of the file, with the
  // number of its column from 0.
  std::vector<std::pair<std::size_t, base::Error>> words;

  [[nodiscard]] bool has_heading() const { return !heading.names.empty(); }
};

// Too many fields in a line, too many numbers or a file without numbers is an error.
[[nodiscard]] base::Result<HeightText> read_height_text(std::string_view text, std::string_view source);

// The error that names the first line whose number of fields differs from that of `first`; empty if there is none.
[[nodiscard]] std::optional<base::Error> unequal_lines(const HeightLine& first, std::span<const HeightLine> lines, std::string_view source);

// "line:column"
[[nodiscard]] std::string place_of(std::size_t line, std::size_t column);

// "1 line", "2 lines"
[[nodiscard]] std::string count_of(std::size_t n, std::string_view what);

}  // namespace sightline::scene
