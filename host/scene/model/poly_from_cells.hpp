// Converts a cell scene to a scene of polyhedra, so that drawings of both can be compared.
//
// Every solid becomes a body, all walls together a sheet. The outer box, which hides nothing, cells and
// openings are left out. The camera is the eye of the default view looking along z, y up. A PolyScene has the
// edges of its faces only. Where two solids touch face to face, or two walls lie side by side in one plane,
// both keep their joint line, which a drawing of the union does not have. A caller that needs the union's
// lines removes the stretches where coplanar faces meet from both sides.
#pragma once

#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

// The cell scene is a checked one.
[[nodiscard]] PolyScene poly_scene_of(const CellScene& cells);

}  // namespace sightline::scene
