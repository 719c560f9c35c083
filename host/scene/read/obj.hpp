// Reading polyhedra from Wavefront OBJ.
//
// `v x y z` is a vertex (a weight or colour behind it is passed over), `f` a face; its corners are v, v/vt,
// v//vn or v/vt/vn, v counting from 1 or, if negative, back from the vertex read last. The objects (`o`) are
// the bodies, or the groups (`g`) if there are no objects and no vertex is of two groups; a name that comes
// again continues its body. A file without either is one body. Groups that are no bodies and `usemtl` are
// materials. All other statements are passed over, and counted in PolyMesh::notes but for vn, vt, s and mtllib.
#pragma once

#include <string_view>

#include "host/base/result.hpp"
#include "host/scene/read/poly_import.hpp"

namespace sightline::scene {

[[nodiscard]] base::Result<PolyMesh> read_obj(std::string_view text, std::string_view source);

}  // namespace sightline::scene
