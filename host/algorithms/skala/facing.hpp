// Which side of the surface is seen, triangle by triangle. Every cell is two flat triangles, divided by the
// diagonal between its side corners: one lies wholly before the other.
#pragma once

#include <cstddef>

#include "host/algorithms/skala/surface.hpp"

namespace sightline::algorithms::skala {

// As its corners follow each other on the screen; none: there is no such triangle, or it is seen edge-on.
enum class Side { none, anticlockwise, clockwise };

enum class Half { near, far };  // of the cell with its nearest corner at (row, column)

[[nodiscard]] bool cell_defined(const Surface& surface, std::size_t row, std::size_t column);
[[nodiscard]] Side side_of(const Surface& surface, std::size_t row, std::size_t column, Half half);

// Four times the mean height of a cell's corners on the screen; it orders cells of several surfaces over the same place.
[[nodiscard]] double middle_of(const Surface& surface, std::size_t row, std::size_t column);

// Of an edge at which the surface turns away: is nothing of the surface around it seen beyond it? Where a steep surface runs towards the
// eye, single triangles turn away from it within the surface; their edges are no outline. `columns` is those of the masks.
[[nodiscard]] bool is_outline(const Surface& surface, std::size_t from_row, std::size_t from_column, std::size_t to_row, std::size_t to_column, int columns);

// Of an edge between two triangles: does the surface turn away from the eye there?
[[nodiscard]] inline bool folds(Side a, Side b) {
  return a != Side::none && b != Side::none && a != b;
}

}  // namespace sightline::algorithms::skala
