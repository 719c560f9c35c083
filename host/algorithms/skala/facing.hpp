// Tells which side of the surface is visible, triangle by triangle. Every cell is two flat triangles, divided by the
// diagonal between its side corners; one is wholly before the other.
#pragma once

#include <cstddef>

#include "host/algorithms/skala/surface.hpp"

namespace sightline::algorithms::skala {

// The order of its corners on the screen. none: there is no such triangle, or it is seen edge-on.
enum class Side { none, anticlockwise, clockwise };

enum class Half { near, far };  // of the cell whose nearest corner is at (row, column)

[[nodiscard]] bool cell_defined(const Surface& surface, std::size_t row, std::size_t column);
[[nodiscard]] Side side_of(const Surface& surface, std::size_t row, std::size_t column, Half half);

// Four times the mean height on the screen of a cell's corners. Orders the cells of several surfaces at the same place.
[[nodiscard]] double middle_of(const Surface& surface, std::size_t row, std::size_t column);

// Whether nothing of the surface around an edge is visible beyond it, for an edge at which the surface turns away. Where
// a steep surface runs towards the eye, single triangles inside it are turned away; their edges are not outlines.
// `columns` is the number of columns of the masks.
[[nodiscard]] bool is_outline(const Surface& surface, std::size_t from_row, std::size_t from_column, std::size_t to_row, std::size_t to_column, int columns);

// Whether the surface turns away from the eye at the edge between two triangles.
[[nodiscard]] inline bool folds(Side a, Side b) {
  return a != Side::none && b != Side::none && a != b;
}

}  // namespace sightline::algorithms::skala
