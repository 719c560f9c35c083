// The screen positions of the points of a grid, and the order of drawing: rotation about the vertical, parallel projection
// from an elevation, fit to the 256 x 256 raster. Verticals stay vertical, which Skala's masks require (Skala 1985, section
// 3).
//
// With x, z, h in [-1, 1], rotation A and elevation E:
//   screen x = x cos A + z sin A     depth = -x sin A + z cos A     screen y = 0.6 h cos E + depth sin E
// Screen x and y are each fitted to 0..255 by their extremes over the defined points; a coordinate without extent is at
// 128. A zoom enlarges about the middle, 127.5.
#pragma once

#include <cstddef>
#include <vector>

#include "host/algorithms/skala/view.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::programs::skala {

using algorithms::skala::Family;
using algorithms::skala::Subject;
using algorithms::skala::View;

struct SineCosine {
  double sine = 0;
  double cosine = 1;
};

// Exact at multiples of 90 degrees and with exact symmetries: the sine of A is the cosine of 90 - A, bit for
// bit. Any finite angle.
[[nodiscard]] SineCosine sine_and_cosine(double degrees);

inline constexpr int raster_side = 256;  // dots

// A real screen coordinate as a raster coordinate: rounded once, halves upwards. A value up to a millionth of a dot below a
// half counts as the half, so that points of a symmetric surface do not depend on the last bit of a sine. Beyond +-2^20 the
// result is +-2^20.
[[nodiscard]] int raster_coordinate(double value);

struct Vertex {
  double x = 0;  // real screen coordinates: 0..255 without a zoom
  double y = 0;  // (only if defined)
  int column = 0;
  int row = 0;
  double depth = 0;      // greater is farther
  bool defined = false;  // x, column and depth are valid even if false
};

class Projection {
 public:
  // Heights are scaled by the grid's range. View: rotation, elevation and zoom are used.
  Projection(const scene::HeightGrid& grid, const View& view);

  [[nodiscard]] const Vertex& at(std::size_t point, std::size_t slice) const {
    return vertices_[slice * points_ + point];
  }
  [[nodiscard]] std::size_t points() const { return points_; }
  [[nodiscard]] std::size_t slices() const { return slices_; }
  [[nodiscard]] SineCosine rotation() const { return rotation_; }

 private:
  std::size_t points_;
  std::size_t slices_;
  SineCosine rotation_;
  std::vector<Vertex> vertices_;
};

// A height as h in [-1, 1] by the grid's range; 0 if that is empty; NaN for an undefined height.
[[nodiscard]] double normalised_height(const scene::HeightGrid& grid, double height);

// The order in which a grid is drawn: from the foreground to the background, for any rotation (Skala 1985, section 3: "the
// problem is how to select the order of the drawing if some transformations are made").
//
// An order is a view of the grid with its axes exchanged and reversed so that rows[0] is nearest. Along a vertical line of
// the screen depth grows with z / cos A in slices along x and with -x / sin A in slices along z, which gives the sign of
// both; cells recede from the corner nearest the eye in both directions.

struct GridIndex {
  std::size_t point = 0;
  std::size_t slice = 0;

  friend bool operator==(const GridIndex&, const GridIndex&) = default;
};

struct DrawingOrder {
  std::size_t rows = 0;     // near to far
  std::size_t columns = 0;  // slices: from left to right; cells: near to far too
  bool row_is_slice = true;
  bool rows_reversed = false;
  bool columns_reversed = false;
  double row_shift = 0;  // > 0 if screen x grows from a row to the next farther one; 0: constant
  double column_shift = 0;

  [[nodiscard]] GridIndex index(std::size_t row, std::size_t column) const {
    const std::size_t r = rows_reversed ? rows - 1 - row : row;
    const std::size_t c = columns_reversed ? columns - 1 - column : column;
    return row_is_slice ? GridIndex{c, r} : GridIndex{r, c};
  }
};

// The family to draw at a rotation if only one is drawn: along_x or along_z.
[[nodiscard]] Family less_end_on(SineCosine rotation);

// Rows are the slices of the family (along_x or along_z). A direction that does not matter keeps that of the index.
[[nodiscard]] DrawingOrder slice_order(const Projection& projection, Family family);

// Row by row from the nearest corner, for cells.
[[nodiscard]] DrawingOrder cell_order(const Projection& projection);

}  // namespace sightline::programs::skala
