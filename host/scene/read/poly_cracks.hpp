// Closes cracks of a mesh: open edges that the numbers of the file put on each other. The rules are in poly_mend.hpp.
#pragma once

#include <span>

#include "host/scene/model/edge_table.hpp"
#include "host/scene/read/mended_mesh.hpp"
#include "host/scene/read/open_vertices.hpp"

namespace sightline::scene {

// Both change pieces and return whether they did; `edges` are those of the pieces, `open` the open ones of these.

// Joins ends of open edges that only rounding keeps apart.
bool join_ends(MendedMesh& mesh, const EdgeTable& edges, std::span<const OpenEdge> open);
// Divides open edges at ends of other ones.
bool divide_edges(MendedMesh& mesh, const EdgeTable& edges, std::span<const OpenEdge> open);

}  // namespace sightline::scene
