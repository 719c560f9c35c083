// Free leaves joined again where two make one convex cell: a BSP cuts everything in a part of space by a
// plane that only one face in it needs.
//
// Two leaves on both sides of a plane make a convex whole just if each is within all other bounds of the
// other; the whole of the polygon between them must be open. Joined greedily, in the order of portals, again
// and again until nothing can be joined: the order decides how few cells are left, and no order is known to
// be best.
#pragma once

#include <cstdint>
#include <vector>

#include "host/scene/cells/builder.hpp"
#include "host/scene/cells/bsp/tree.hpp"

namespace sightline::scene {

// By node, the leaf that it is part of now, itself if nothing has changed. A leaf that has become part of
// another has no portals left, a portal that is no longer there is empty. Of two portals to the same leaf
// one is made.
[[nodiscard]] std::vector<std::uint32_t> join_leaves(CellComplexBuilder& builder,
                                                     const std::vector<bool>& is_free, BspTree& tree);

}  // namespace sightline::scene
