// The BSP tree over the planes of faces, and the portals between its leaves.
//
// A portal is a convex polygon between two parts of space, one of which is behind its plane. When a part is
// split, its portals are split with it, and the splitting plane's polygon within the part becomes a new
// portal. The portals of a part therefore cover its surface, and their planes are exactly its bounds.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "host/scene/cells/builder.hpp"
#include "host/scene/cells/bsp/faces.hpp"
#include "host/scene/cells/bsp/polygon.hpp"

namespace sightline::scene {

inline constexpr std::uint32_t no_node = std::numeric_limits<std::uint32_t>::max();

struct BspNode {
  std::uint32_t plane = 0;
  std::array<std::uint32_t, 2> children{no_node, no_node};  // behind, in front; a leaf has none

  [[nodiscard]] bool is_leaf() const { return children[0] == no_node; }
};

struct BspPortal {
  PlanePolygon polygon;
  std::array<std::uint32_t, 2> nodes{no_node, no_node};  // behind the portal's plane, in front of it; no_node is the outside
  std::vector<std::uint32_t> faces;  // pieces in its plane: at least all that cover a part of it
};

struct BspTree {
  std::vector<BspNode> nodes;  // the root is first
  std::vector<BspPortal> portals;
  std::vector<std::vector<std::uint32_t>> portals_of;  // by node, empty unless it is a leaf
  std::vector<FacePiece> faces;                        // pieces in the planes of nodes, indexed by portals
};

// The half-spaces whose intersection is the leaf, each once.
[[nodiscard]] std::vector<HalfSpace> bounds_of(const BspTree& tree, std::uint32_t node);

// Empty if the tree would have more than `most_leaves` leaves.
[[nodiscard]] std::optional<BspTree> build_bsp_tree(std::vector<FacePiece> faces, CellComplexBuilder& builder,
                                                    std::size_t most_leaves);

}  // namespace sightline::scene
