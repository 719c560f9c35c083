// Reads a surface of heights from a file. The first entry of this list that recognises the file reads it:
//
//   grid_formats.hpp   ESRI, Surfer, HGT: a header or the size says what the file is.
//   table    A text. The first line has the places along x, the first column those along y, at any distances; both rise or fall.
//            The corner is a name, empty, the number of columns (gnuplot's `nonuniform matrix`), or a number that does not
//            continue both rows of places, which are equidistant, three or more.
//   points   A text. A line is a point, in any order: x, y (our z), the height; further columns are ignored. Recognised by
//            - a heading that names the columns (x y z, lon lat elevation, ...),
//            - blank lines between blocks of two or more lines, of three or more columns,
//            - the first two of three or more columns, if they repeat as the places of a grid,
//            - three columns in more than three lines, or four to seven columns in more than three times as many lines.
//   column   A text of one height a line, with blank lines between slices of equal length. Places count from 0.
//   matrix   Any other text with the same number of fields in every line. A line is a slice, the first one nearest to an eye that
//            looks along +z. Places count from 0.
//
// Points over a grid, in blocks or not, become a HeightGrid. Blocks of equal length along which x and y change, or whose points
// form no grid, become a SurfaceNet, as in gnuplot. All other points are an error, unless the options ask for a triangulation; they
// are never a matrix. If neither the format, nor a heading, nor the options determine the layout, the note says how the file was
// read.
//
// Semicolons, commas, tabs or blanks separate the fields: the first of these that the file has. With semicolons a fraction may have
// a decimal comma. A field is a decimal number with a point; it may stand in quotation marks. An empty field, nan, NA, N/A and null
// are holes. A first line of words is a heading. # begins a comment, % a line of comment. A line end is LF, CRLF or CR. A byte order
// mark is skipped. A separator at the end of every line ends no field. Errors are infinities, lines of unequal length, fewer than two
// lines or columns, more than 1024 after thinning, and a file without numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/heights/grid.hpp"
#include "host/scene/heights/surface_net.hpp"

namespace sightline::scene {

// How a person says what a file of heights has.

enum class GridLayout : std::uint8_t { by_content, matrix, table, points };

struct GridFileOptions {
  // Three columns of points, by their names in the heading or by number from 1: x, z and height. Empty: by content.
  std::vector<std::string> columns = {};
  // With columns it is points or by_content. Not of files that say themselves what they are: ESRI, Surfer, HGT.
  GridLayout layout = GridLayout::by_content;
  std::optional<double> nodata = {};  // heights that are holes, besides those that the format calls so
  // Every n-th point and slice is taken, from 1. Empty: all, and an error that says how to thin a larger grid than largest_grid.
  std::optional<std::size_t> thin = {};
  // In place of that error such a grid is thinned, as the note says.
  bool thin_to_fit = false;
  // Points are triangulated, and the surface is sampled at this size.
  std::optional<GridSize> triangulate = {};
};

inline constexpr std::uintmax_t largest_grid_file = std::uintmax_t{128} << 20;

// `source`, the file's name, is named in errors, with line and column or the byte of the first one.
[[nodiscard]] base::Result<HeightSurface> read_height_surface(std::string_view bytes, std::string_view source,
                                                              const GridFileOptions& options = {});
// The same; a net is an error.
[[nodiscard]] base::Result<HeightGrid> read_height_grid(std::string_view bytes, std::string_view source,
                                                        const GridFileOptions& options = {});

// Of a file of at most largest_grid_file bytes.
[[nodiscard]] base::Result<HeightSurface> load_height_surface(const std::string& file, const GridFileOptions& options = {});
[[nodiscard]] base::Result<HeightGrid> load_height_grid(const std::string& file, const GridFileOptions& options = {});

}  // namespace sightline::scene
