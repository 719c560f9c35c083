// The BSP tree over the planes of faces, and the portals between its leaves.
//
// A portal is a convex polygon between two parts of space, one of which is behind its plane. When a part is
// split, so are its portals, and what the splitting plane has within the part becomes a new one; a part's
// portals therefore always cover its surface, and their planes are its bounds, none too many.
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
  std::array<std::uint32_t, 2> nodes{no_node, no_node};  // behind its plane, in front; no_node is outside
  std::vector<std::uint32_t> faces;  // pieces in its plane; all that cover a part of it, maybe others
};

struct BspTree {
  std::vector<BspNode> nodes;  // the root is first
  std::vector<BspPortal> portals;
  std::vector<std::vector<std::uint32_t>> portals_of;  // by node, empty unless it is a leaf
  std::vector<FacePiece> faces;                        // in the planes of nodes: what portals name
};

// The half-spaces whose common part a leaf is, each once.
[[nodiscard]] std::vector<HalfSpace> bounds_of(const BspTree& tree, std::uint32_t node);

// Empty if there would be more than `most_leaves`.
[[nodiscard]] std::optional<BspTree> build_bsp_tree(std::vector<FacePiece> faces, CellComplexBuilder& builder,
                                                    std::size_t most_leaves);

}  // namespace sightline::scene
