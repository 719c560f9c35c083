// Merges free leaves where two make one convex cell. A BSP cuts all of a part of space by a plane that only
// one face in it needs.
//
// The union of two leaves on both sides of a plane is convex exactly if each is within all other bounds of
// the other and they have the whole of their faces in the plane in common. That common polygon must be open.
// Merging is greedy, in the order of portals, and repeats until no two leaves can be merged. The order
// decides how few cells are left; no best order is known.
#pragma once

#include <cstdint>
#include <vector>

#include "host/scene/cells/builder.hpp"
#include "host/scene/cells/bsp/tree.hpp"

namespace sightline::scene {

// By node, the leaf that it is now part of: itself if it was not merged. A leaf merged into another has no
// portals left, and a removed portal is empty. Two portals to the same leaf become one.
[[nodiscard]] std::vector<std::uint32_t> join_leaves(CellComplexBuilder& builder,
                                                     const std::vector<bool>& is_free, BspTree& tree);

}  // namespace sightline::scene
