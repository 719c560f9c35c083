// Skala's hidden lines, surfaces and contours (1985) for people who plot surfaces today: vectors, not dots.
//
// The method is the paper's: from the foreground to the background, against the highest and the lowest point
// drawn so far in every column. What differs: the masks are finer than a dot and lines end where they meet
// the horizon; both families of slices go cell by cell; the surface's own edges are in the masks; first
// points are drawn. The printed programs' mistakes are corrected.
// A surface with holes, and several surfaces in one picture, take a set of intervals a column in place of one (gapped_horizon.hpp).
// Memory and time are linear in the grid. The same grid gives the same drawing with every compiler.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "host/algorithms/skala/horizon.hpp"
#include "host/algorithms/skala/view.hpp"
#include "host/picture/vector_drawing.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::algorithms::skala {

// Layers, always in this order: slices along x ("lines along x"), along z, rims, silhouette; for contours a
// layer a level, lowest first, from 4 on ("contour HEIGHT"). 255 x 255 units. Any size from an empty grid on.
// Surfaces are facets: of every cell that is seen at least in part, far to near, in greys by the slope
// across the picture's x of the data, as in the paper's shading; cells hidden wholly are left out.
[[nodiscard]] picture::VectorDrawing draw(const scene::HeightGrid& grid, const View& view);
// Surfaces over the same places, with the same range (precondition; one or more), which hide each other. The layers of each follow those
// of the one before; from the second on their names end in ", surface N". The last layer, "intersections", has the lines in which they pass
// through each other.
[[nodiscard]] picture::VectorDrawing draw(std::span<const scene::HeightGrid> grids, const View& view);
// The colour of its lines, from 0.
[[nodiscard]] picture::Colour surface_colour(std::size_t surface);

// What a drawing tells of its work. One that nobody watches is compiled apart and pays nothing.
class Trace {
 public:
  virtual ~Trace() = default;
  // A line from point to point was compared with the masks, which then have it: its visible pieces.
  virtual void line(std::span<const Vertex> line, std::span<const Piece> seen) = 0;
  // The masks when a row of the grid is done, the nearest row first: heights by column; beyond 10^29 nothing was drawn there.
  virtual void row_ended(std::span<const float> top, std::span<const float> bottom) = 0;
};
[[nodiscard]] picture::VectorDrawing draw(const scene::HeightGrid& grid, const View& view, Trace& trace);

}  // namespace sightline::algorithms::skala
