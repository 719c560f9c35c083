// A grid file as lines of fields, before anything is known of their meaning.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::scene {

struct HeightField {
  double value = 0;
  std::size_t column = 1;  // in the line, from 1
};

struct HeightLine {
  std::vector<HeightField> fields;
  std::size_t number = 1;    // in the file, from 1
  std::size_t end = 1;       // the column behind its last character
  bool after_blank = false;  // empty lines are before it (other than at the start of the file)
};

struct HeightText {
  bool separated = false;         // by commas or semicolons
  std::vector<HeightLine> lines;  // at least one; none empty
};

// A field that is no number, more than 1024 fields in a line or a file without numbers is an error.
[[nodiscard]] base::Result<HeightText> read_height_text(std::string_view text, std::string_view source);

// "line:column"
[[nodiscard]] std::string place_of(std::size_t line, std::size_t column);

}  // namespace sightline::scene
