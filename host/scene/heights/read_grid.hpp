// Reading a HeightGrid from a text file. Its layout is the first of these whose test it passes:
//
//   ESRI     The first word is ncols or nrows, followed by a number: an ASCII grid of ESRI.
//   Surfer   The first word is DSAA: an ASCII grid of Surfer.
//   table    The first line has the places along x and the first column those along y, at any distances, both rising or both
//            falling, or one of each. The corner is a name, empty, the number of columns (gnuplot's `nonuniform matrix`), or a
//            number that does not continue both rows of places, which are three or more at equal distances.
//   points   A line is a point, in any order: x, y (our z), the height. Further columns are left out. So is gnuplot's grid data
//            with blank lines between curves. Told by a heading that names the columns (x y z, lon lat elevation, ...); by the
//            first two of three or more columns, which repeat as the places of a grid; or by few columns for many lines: more
//            than 3 n lines of n = 3 to 7 numbers, more than three lines of three numbers whose first two are never missing (but
//            not if one of the first two is always the same and the other one has a value twice), three lines of three numbers
//            with a blank line between two of them.
//   matrix   Anything else with as many fields in every line. A line is a slice, the first one nearest to an eye that looks
//            along +z. Places are counted from 0.
//
// Points that form no grid are an error, never a matrix. GridFileOptions say which layout it is where that is known better. A
// layout that neither the format, nor a heading, nor the options tell is a guess: the grid's note says it.
//
// Fields are separated by semicolons, commas, tabs or blanks: the first of these that the file has. An empty field is a hole.
// With semicolons a fraction may have a decimal comma. A field may stand in quotation marks. A first line of texts is a heading.
// # begins a comment, and % a line of comment. Lines of blanks only are empty, line ends are LF or CRLF, a byte order mark is
// passed over. A field is a decimal number with a point, or nan, NA, N/A or null for an undefined height. A separator at the end
// of every line ends no field. Everything else is an error: infinity, lines of unequal length, fewer than two lines or columns,
// more than 1024, no number anywhere.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::scene {

inline constexpr std::uintmax_t largest_grid_file = std::uintmax_t{64} << 20;

enum class GridLayout : std::uint8_t { by_content, matrix, table, points };

struct GridFileOptions {
  // Three columns of points, by their names in the heading or by number from 1: x, z and height. Empty: by content.
  std::vector<std::string> columns = {};
  // With columns it is points or by_content. Not of files that say themselves what they are: ESRI, Surfer.
  GridLayout layout = GridLayout::by_content;
};

// `source` is named in errors, with line and column of the first one.
[[nodiscard]] base::Result<HeightGrid> read_height_grid(std::string_view text, std::string_view source,
                                                        const GridFileOptions& options = {});

// A file of at most largest_grid_file bytes.
[[nodiscard]] base::Result<HeightGrid> load_height_grid(const std::string& file, const GridFileOptions& options = {});

}  // namespace sightline::scene
