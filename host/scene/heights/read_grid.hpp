// Reading a surface of heights from a file. The first of these that recognises the file reads it:
//
//   grid_formats.hpp  A grid that says itself what it is: ESRI, Surfer, HGT.
//   table    A text whose first line has the places along x and whose first column has those along y, at any distances, both rising
//            or both falling, or one of each. The corner is a name, empty, the number of columns (gnuplot's `nonuniform matrix`), or
//            a number that does not continue both rows of places, which are three or more at equal distances.
//   points   A line is a point, in any order: x, y (our z), the height. Further columns are left out. Recognised by a heading that names
//            the columns (x y z, lon lat elevation, ...); by three or more columns with blank lines between blocks of two or more lines; by the first two of
//            three or more columns, which repeat as the places of a grid; by three columns in more than three lines; or by four to
//            seven columns in more than three times as many lines.
//   column   One height a line, with blank lines between slices of equal length. Places are counted from 0.
//   matrix   Anything else with as many fields in every line. A line is a slice, the first one nearest to an eye that looks
//            along +z. Places are counted from 0.
//
// Points over a grid, in blocks or not, become a HeightGrid. Blocks of equal length along which x and y change, or whose points form
// no grid, are the curves of a SurfaceNet, as gnuplot has them. Other points are an error, unless they are to be triangulated; they are never a matrix. GridFileOptions say which layout it
// is where a person knows it. A layout that neither the format, nor a heading, nor the options tell is said in the note.
//
// Fields are separated by semicolons, commas, tabs or blanks: the first of these that the file has. An empty field is a hole.
// With semicolons a fraction may have a decimal comma. A field may stand in quotation marks. A first line of texts is a heading.
// # begins a comment, and % a line of comment. Lines of blanks only are empty, line ends are LF or CRLF, a byte order mark is
// passed over. A field is a decimal number with a point, or nan, NA, N/A or null for an undefined height. A separator at the end
// of every line ends no field. Everything else is an error: infinity, lines of unequal length, fewer than two lines or columns,
// more than 1024 after thinning, no number anywhere.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "host/base/result.hpp"
#include "host/scene/heights/grid.hpp"
#include "host/scene/heights/grid_options.hpp"
#include "host/scene/heights/surface_net.hpp"

namespace sightline::scene {

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
