// Converts the hand-made cells of a cell scene to a cell complex.
//
// Cells and openings are the scene's, in its order. The openings to `outside` follow: the parts of the cells'
// faces on the outer box that no wall covers. From outside, and for orthographic views, the outer box hides
// nothing. From inside it is opaque: there is nothing to see beyond it, and a search that starts inside may
// stop there, as in the paper.
//
// Limit: an edge of matter on the outer box that no free cell touches (between two solids that both end
// there) belongs to no cell and is not seen from outside. decompose_grid leaves a free layer all round and
// has no such limit.
#pragma once

#include "host/scene/model/cell_complex.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

// The cell scene is a checked one. Vertices and edges come from `poly`, which is poly_scene_of(cells) or a
// scene with the same matter and wires for lines.
[[nodiscard]] CellComplex complex_of(const CellScene& cells, const PolyScene& poly);

}  // namespace sightline::scene
