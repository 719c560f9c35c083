// Reading a HeightGrid from a text file. The form is recognised by the content:
//
//   CSV      some line has a semicolon or a comma, or every line as many tabs: that separates the fields (the first of
//            the three that occurs). Each line is a slice, the first one nearest to an eye that looks along +z. An empty field
//            is a hole. With semicolons a fraction may have a decimal comma. A field may stand in quotation marks.
//
//   matrix   fields separated by blanks, one line per slice: gnuplot's `matrix` (not `nonuniform matrix`).
//
//   table    the first line has the places along x and the first column those along z, at any distances, rising or
//            falling. The corner is a text that is no number; or it is empty, and both sets of places rise or fall.
//
//   blocks   three fields on every line and blank lines between blocks: gnuplot's x y z grid data. A block is
//            a curve of constant x or of constant y, where y is our z. Curves may be in either direction and at
//            unequal distances; every block has the same places.
//
//   points   a heading that names columns x, y and z (or x, z and height, or lon, lat and elevation, among others); or three
//            columns, of which the first two repeat as the places of a grid do. A line is a point, in any order; places differ by more than 10^-9 of the extent. A place without a point is a hole, two points are an error.
//
// A first line of texts is a heading; in the first two forms its names mean nothing. A # starts a comment, lines of blanks only
// are empty (between matrix rows they mean nothing), line ends are LF or CRLF, a byte order mark is passed over. A field is a
// decimal number with a point, or nan, NA, N/A or null for an undefined height. A separator at the end of every line
// ends no field. Everything else is an error: infinity, lines of unequal length, fewer than two lines or columns, more than
// 1024, no number anywhere.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::scene {

inline constexpr std::uintmax_t largest_grid_file = std::uintmax_t{64} << 20;

struct GridFileOptions {
  // Three columns of points, by their names in the heading or by number from 1: x, z and height. Empty: by content.
  std::vector<std::string> columns = {};
};

// `source` is named in errors, with line and column of the first one.
[[nodiscard]] base::Result<HeightGrid> read_height_grid(std::string_view text, std::string_view source,
                                                        const GridFileOptions& options = {});

// A file of at most largest_grid_file bytes.
[[nodiscard]] base::Result<HeightGrid> load_height_grid(const std::string& file, const GridFileOptions& options = {});

}  // namespace sightline::scene
