// Automatic decomposition by growth in a grid: free space between faces parallel to the axes, cut into
// boxes. What Jones (1971) called highly desirable and left open, for the cells his program allowed.
//
// The planes of all faces make a grid. Units of it inside a solid are left out (a winding sum along x, so
// that bodies may touch, share faces or overlap). From the first free unit on, a box grows along x, then z,
// then y, as long as a whole slab is free and no sheet crosses it: never across a wall and never around one.
// Two boxes meet in a rectangle; what sheets leave free of it is cut into openings, greatest width first.
//
// Only planes of faces divide the grid, not the outlines of sheets: a door needs no plane of its own through
// the whole building. A unit's face may therefore be covered in part; no box grows across it, and its free
// part becomes openings. A building of a million rooms with doors has a grid of a million units.
//
// Costs: time and memory linear in units plus openings plus lines; nothing is compared in pairs.
#pragma once

#include <cstddef>
#include <optional>

#include "host/base/result.hpp"
#include "host/scene/model/cell_complex.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

struct GridOptions {
  std::size_t most_units = 10'000'000;
};

// Why a scene cannot be cut by a grid: a face or a side of one that is not parallel to the axes (named as
// "body 0, face 0"), or more units than allowed. Empty if it can.
[[nodiscard]] std::optional<base::Error> why_no_grid(const PolyScene& scene, const GridOptions& options = {});

// Of a checked scene. The outer box is the one of outer_box_of. Fails as why_no_grid says, or if one
// rectangle between two cells is cut into more than most_units parts by the outlines of sheets.
[[nodiscard]] base::Result<CellComplex> decompose_grid(const PolyScene& scene,
                                                       const GridOptions& options = {});

}  // namespace sightline::scene
