// A cell scene as a scene of polyhedra, so that what draws one can be compared with what draws the other.
//
// Every solid becomes a body, all walls together a sheet; the outer box, which hides nothing, is left out,
// and so are cells and openings. The camera is the eye of the default view looking along z, y up. Edges: a
// PolyScene has the edges of its faces and nothing else. Where two solids touch face to face, or two walls
// lie side by side in one plane, their joint line stays an edge of both, which a drawing of the union has
// not; a caller that needs the union's lines leaves out the stretches where coplanar faces meet from both sides.
#pragma once

#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

// Of a checked scene.
[[nodiscard]] PolyScene poly_scene_of(const CellScene& cells);

}  // namespace sightline::scene
