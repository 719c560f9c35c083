// Skala's hidden lines, surfaces and contours (1985) as a modern plotter: vectors instead of dots.
//
// The method is the paper's: from the foreground to the background, comparing with the highest and the lowest point drawn
// so far in every column. Differences: the masks are finer than a dot, and lines end where they meet the horizon; both
// families of slices are processed cell by cell; the masks include the surface's own edges; first points are drawn. The
// errors of the printed programs are corrected.
// For a surface with holes, and for several surfaces, the mask of a column is a set of intervals (gapped_horizon.hpp).
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

// Layers, always in this order: slices along x ("lines along x"), along z, rims, silhouette; for contours one layer per
// level, lowest first, from layer 4 on ("contour HEIGHT"). The drawing is 255 x 255 units. Grids of any size, also empty
// ones, are accepted. Surfaces are facets, far to near, one for every cell that is at least partly visible, in greys by
// the slope of the data across the picture's x, as in the paper's shading.
[[nodiscard]] picture::VectorDrawing draw(const scene::HeightGrid& grid, const View& view);
// Several surfaces, which hide each other. Precondition: one or more grids, with the same coordinates and range. The
// layers of each surface follow those of the one before; from the second on, their names end in ", surface N". The last
// layer, "intersections", contains the lines in which the surfaces pass through each other.
[[nodiscard]] picture::VectorDrawing draw(std::span<const scene::HeightGrid> grids, const View& view);
// The colour of a surface's lines. Surfaces are numbered from 0.
[[nodiscard]] picture::Colour surface_colour(std::size_t surface);

// The events that a drawing reports to a listener. Drawing without a listener is compiled separately and has no cost for
// it.
class Trace {
 public:
  virtual ~Trace() = default;
  // A line was compared with the masks, which now include it; `seen` are its visible pieces.
  virtual void line(std::span<const Vertex> line, std::span<const Piece> seen) = 0;
  // The masks at the end of a row of the grid, nearest row first: heights by column; a magnitude above 10^29 means that
  // nothing was drawn there.
  virtual void row_ended(std::span<const float> top, std::span<const float> bottom) = 0;
};
[[nodiscard]] picture::VectorDrawing draw(const scene::HeightGrid& grid, const View& view, Trace& trace);

}  // namespace sightline::algorithms::skala
