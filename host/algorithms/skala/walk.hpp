// The way through a grid from the foreground to the background: every edge of the surface once, tested
// against what is nearer, inked if it is wanted, and added to the masks.
//
// Cell by cell from the nearest corner: a cell's near edges have been drawn; then come contours on its near
// triangle, its diagonal, contours on its far triangle, and last its two far edges, which lie behind no part
// of the cell (Skala 1985, sections 3 to 5). In a picture of slices only the edges of the surface are drawn
// between them: with these every part of the surface's outline is in the masks.
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
  std::vector<std::uint8_t> bands;  // contours: how many levels are at or below every vertex
  std::vector<double> heights;      // contours, several surfaces: of every vertex
  std::vector<double> levels;
  std::uint32_t first_layer = 0;  // of the drawing: those of Layer count from it
};

struct Walked {
  std::vector<bool> seen;  // surfaces: of every cell, by row * (columns - 1) + column; empty otherwise
};

// The drawing's layers must be there; lines are added to it. A surface with holes takes a GappedHorizon.
Walked walk(const Walk& order, picture::VectorDrawing& drawing);
// The same, told to somebody.
Walked walk(const Walk& order, picture::VectorDrawing& drawing, Trace& trace);

// Several surfaces over the same places at once, cell by cell; of two in a cell the one on the eye's side comes first. Where two pass
// through each other within a cell, each line of it is compared with the other surfaces where they are on the eye's side of it, and the
// line in which they meet is added to the layer `meetings`.
std::vector<Walked> walk(std::span<const Walk> orders, picture::VectorDrawing& drawing, std::uint32_t meetings);

}  // namespace sightline::algorithms::skala
