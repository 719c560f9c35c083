// In which order a grid is drawn: from the foreground to the background, whatever the rotation (Skala 1985,
// section 3: "the problem is how to select the order of the drawing if some transformations are made").
//
// An order is a view of the grid with its axes exchanged and reversed so that rows[0] is nearest. Along a
// vertical line of the screen depth grows with z / cos A in slices along x and with -x / sin A in slices
// along z, which gives the sign of both; cells go away from the corner nearest the eye in both directions.
#pragma once

#include <cstddef>

#include "host/guests/skala/projection.hpp"
#include "host/guests/skala/view.hpp"

namespace sightline::guests::skala {

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
  double row_shift = 0;  // > 0 if screen x grows from a row to the next farther one, 0: not at all
  double column_shift = 0;

  [[nodiscard]] GridIndex index(std::size_t row, std::size_t column) const {
    const std::size_t r = rows_reversed ? rows - 1 - row : row;
    const std::size_t c = columns_reversed ? columns - 1 - column : column;
    return row_is_slice ? GridIndex{c, r} : GridIndex{r, c};
  }
};

// The family that is drawn: along_x or along_z, for one family at a rotation.
[[nodiscard]] Family less_end_on(SineCosine rotation);

// Rows are the slices of the family (along_x or along_z). Of directions that do not matter the index's own
// is taken.
[[nodiscard]] DrawingOrder slice_order(const Projection& projection, Family family);

// Row-major from the nearest corner, for cells.
[[nodiscard]] DrawingOrder cell_order(const Projection& projection);

}  // namespace sightline::guests::skala
