// The hand-made cells of a cell scene as a cell complex.
//
// Cells and openings are the scene's, in its order. After them come the openings to `outside`: what of the
// cells' faces on the outer box no wall covers. The outer box is thus opaque only to an eye that is inside and
// looks for lines: beyond it there is nothing to see, and a walk that starts inside may stop there, as in the
// paper. From outside, and for orthographic views, it hides nothing.
//
// Limit: an edge of matter that lies on the outer box where no free cell touches it (between two solids that
// both end there) belongs to no cell and is not seen from outside. decompose_grid leaves a free layer all
// round and has no such limit.
#pragma once

#include "host/scene/model/cell_complex.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

// Of a checked scene; vertices and edges come from `poly`: poly_scene_of(cells), or a scene with the same matter and wires for lines.
[[nodiscard]] CellComplex complex_of(const CellScene& cells, const PolyScene& poly);

}  // namespace sightline::scene
