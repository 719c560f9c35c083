// Source texts and positions in them, common to all assemblers.
#pragma once

#include <compare>
#include <cstddef>
#include <string>

namespace sightline::assembler {

struct SourceFile {
  std::string name;  // as messages show it
  std::string text;
};

// A position in one of the files. Lines and columns count from 1, columns in bytes (a tab is one). Line 0 is outside all
// files: a symbol of the machine or of the command line.
struct Position {
  std::size_t file = 0;
  std::size_t line = 0;
  std::size_t column = 0;

  friend auto operator<=>(const Position&, const Position&) = default;
};

}  // namespace sightline::assembler
