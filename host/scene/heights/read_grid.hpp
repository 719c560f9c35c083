// Reading a HeightGrid from a text file. Three forms, recognised by their content:
//
//   CSV      some line has a comma or a semicolon, which separates the fields (if both, the semicolon). Each
//            line is a slice, the first one nearest to an eye that looks along +z.
//
//   matrix   fields separated by blanks or tabs, one line per slice: gnuplot's `matrix` (not `nonuniform matrix`).
//
//   points   three fields on every line and blank lines between blocks: gnuplot's x y z grid data. A block is
//            a curve of constant x or of constant y, where y is our z. Curves may be in either direction and at
//            unequal distances; every block has the same places.
//
// A # starts a comment, lines of blanks only are empty (between matrix rows they mean nothing), line ends are
// LF or CRLF, a byte order mark is passed over. A field is a decimal number with a point, or the word nan for
// an undefined height. Everything else is an error: an empty field, a heading, infinity, lines of unequal
// length, fewer than two lines or columns, more than 1024, no number anywhere.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "host/base/result.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::scene {

inline constexpr std::uintmax_t largest_grid_file = std::uintmax_t{64} << 20;

// `source` is named in errors, with line and column of the first one.
[[nodiscard]] base::Result<HeightGrid> read_height_grid(std::string_view text, std::string_view source);

// A file of at most largest_grid_file bytes.
[[nodiscard]] base::Result<HeightGrid> load_height_grid(const std::string& file);

}  // namespace sightline::scene
