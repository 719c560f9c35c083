// Which cell of a height grid is seen at each of the 256 by 256 points, by comparing depths: the reference
// for native pictures of surfaces, which are facets painted from far to near.
//
// A cell is two flat triangles, divided between the corners at its sides as seen. Cells are numbered from 1,
// x first; 0 is where there is no surface. A point on a side may be either cell's.
#pragma once

#include "host/guests/skala/view.hpp"
#include "host/picture/pixel_metrics.hpp"
#include "host/picture/vector_drawing.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::compare {

// Places nearer than this, in dots, are one: those of a native drawing are multiples of far less.
inline constexpr double same_place = 0.02;

// The grid is a whole one of at least two by two, the view without zoom (preconditions of both).
[[nodiscard]] picture::PixelGrid nearest_cells(const scene::HeightGrid& grid,
                                               const guests::skala::View& view);
// The topmost facet of a native drawing of the same view, by the cell it lies on; a facet that lies on none
// is numbered behind all cells.
[[nodiscard]] picture::PixelGrid painted_cells(const scene::HeightGrid& grid, const guests::skala::View& view,
                                               const picture::VectorDrawing& drawing);

}  // namespace sightline::compare
