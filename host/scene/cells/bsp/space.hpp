// Finds the free leaves of the tree, and the open parts of its portals.
#pragma once

#include <cstdint>
#include <vector>

#include "host/scene/cells/bsp/tree.hpp"

namespace sightline::scene {

// By node; false for nodes that are not leaves. A leaf is solid if a path from outside to it enters more
// solids than it leaves.
[[nodiscard]] std::vector<bool> free_leaves(const Planes& planes, const BspTree& tree);

// The parts of a portal that no sheet covers, as convex polygons.
[[nodiscard]] std::vector<PlanePolygon> open_parts(const Planes& planes, const BspTree& tree,
                                                   const BspPortal& portal);

}  // namespace sightline::scene
