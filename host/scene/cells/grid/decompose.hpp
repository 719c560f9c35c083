// Automatic decomposition by a grid: cuts the free space between axis-parallel faces into boxes. Jones (1971)
// called it highly desirable and left it open; these are the cells that his program allowed.
//
// The planes of all faces make a grid. Its units inside a solid are left out (a winding sum along x, so
// bodies may touch, share faces or overlap). From the first free unit, a box grows along x, then z, then y,
// as long as a whole slab is free and no sheet crosses it; it never contains a wall. Two boxes meet in a
// rectangle. The part of it that sheets leave free is cut into openings, greatest width first.
//
// Only planes of faces divide the grid, not the outlines of sheets, so a door adds no plane through the whole
// building. A sheet may therefore cover a unit's face in part. No box grows across such a face; its free part
// becomes openings. A building of a million rooms with doors has a grid of a million units.
//
// Cost: time and memory are linear in units, openings and lines. No pairs are compared.
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

// Why a scene cannot be cut by a grid: a face or a side that is not parallel to the axes (named as "body 0,
// face 0"), or more units than allowed. Empty if it can.
[[nodiscard]] std::optional<base::Error> why_no_grid(const PolyScene& scene, const GridOptions& options = {});

// The scene is a checked one. The outer box is outer_box_of(scene). Fails for the reasons of why_no_grid, or
// if the outlines of sheets cut one rectangle between two cells into more than most_units parts.
[[nodiscard]] base::Result<CellComplex> decompose_grid(const PolyScene& scene,
                                                       const GridOptions& options = {});

}  // namespace sightline::scene
