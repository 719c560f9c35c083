// Traverses a grid from the foreground to the background. Every edge of the surface is tested once against everything
// nearer, inked if requested, and added to the masks.
//
// The traversal goes cell by cell from the nearest corner. When a cell is reached, its near edges are already drawn. Then
// come the contours on its near triangle, its diagonal, the contours on its far triangle, and last its two far edges,
// which no part of the cell is behind (Skala 1985, sections 3 to 5). In a picture of slices, only the edges of the
// surface are drawn between them; with these, the masks include the whole outline of the surface.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/algorithms/skala/draw.hpp"
#include "host/algorithms/skala/horizon.hpp"
#include "host/algorithms/skala/pen.hpp"
#include "host/algorithms/skala/surface.hpp"
#include "host/algorithms/skala/view.hpp"

namespace sightline::algorithms::skala {

// Layers of the drawing, in order; contour level k is the layer first_contour + k.
enum Layer : std::uint32_t { along_rows, along_columns, rims, silhouettes, first_contour };

struct Walk {
  const Surface* surface = nullptr;
  const View* view = nullptr;
  std::vector<std::uint8_t> bands;  // contours: number of levels at or below each vertex
  std::vector<double> heights;      // contours, several surfaces: by vertex
  std::vector<double> levels;
  std::uint32_t first_layer = 0;  // of the drawing: where the layers of Layer start
};

struct WalkResult {
  std::vector<bool> seen;  // surfaces: by row * (columns - 1) + column, whether the cell is visible; otherwise empty
};

// Adds lines to the drawing, whose layers must exist. A surface with holes takes a GappedHorizon.
WalkResult walk(const Walk& order, picture::VectorDrawing& drawing);
// The same, reporting to `trace`.
WalkResult walk(const Walk& order, picture::VectorDrawing& drawing, Trace& trace);

// Draws several surfaces with the same coordinates at once, cell by cell; in a cell, the surface on the eye's side comes
// first. If two pass through each other within a cell, each line of the cell is compared with the other surfaces where
// they are on the eye's side of it, and the line in which they meet is added to the layer `meetings`.
std::vector<WalkResult> walk(std::span<const Walk> orders, picture::VectorDrawing& drawing, std::uint32_t meetings);

}  // namespace sightline::algorithms::skala
