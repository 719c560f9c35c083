// See space.hpp.
#include "host/scene/cells/bsp/space.hpp"

#include <limits>
#include <utility>

namespace sightline::scene {
namespace {

// How many more solids contain the space behind a portal than the space in front of it. Each leaf is wholly
// inside or outside each solid, so the number is the same all over the portal. One part of it is examined,
// which every face either covers or leaves free.
std::int32_t entered_behind(const Planes& planes, const BspTree& tree, const BspPortal& portal) {
  std::int32_t entered = 0;
  PlanePolygon part = portal.polygon;
  for (const std::uint32_t number : portal.faces) {
    const FacePiece& face = tree.faces[number];
    if (face.sheet) continue;
    PlanePolygon common = intersection(planes, part, face.polygon);
    if (common.empty()) continue;
    part = std::move(common);
    entered += face.turned ? -1 : 1;
  }
  return entered;
}

}  // namespace

std::vector<bool> free_leaves(const Planes& planes, const BspTree& tree) {
  constexpr std::int32_t unknown = std::numeric_limits<std::int32_t>::min();
  std::vector<std::int32_t> depths(tree.nodes.size(), unknown);  // in solids
  std::vector<std::uint32_t> reached;
  for (const BspPortal& portal : tree.portals) {
    const std::uint32_t node = portal.nodes[portal.nodes[0] == no_node ? 1 : 0];
    if (portal.nodes[0] != no_node && portal.nodes[1] != no_node) continue;
    if (depths[node] != unknown) continue;
    depths[node] = 0;
    reached.push_back(node);
  }
  while (!reached.empty()) {
    const std::uint32_t node = reached.back();
    reached.pop_back();
    for (const std::uint32_t number : tree.portals_of[node]) {
      const BspPortal& portal = tree.portals[number];
      const bool forwards = portal.nodes[0] == node;
      const std::uint32_t other = portal.nodes[forwards ? 1 : 0];
      if (other == no_node || depths[other] != unknown) continue;
      const std::int32_t entered = entered_behind(planes, tree, portal);
      depths[other] = depths[node] + (forwards ? -entered : entered);
      reached.push_back(other);
    }
  }
  std::vector<bool> is_free(tree.nodes.size());
  for (std::size_t node = 0; node < is_free.size(); ++node) {
    is_free[node] = tree.nodes[node].is_leaf() && depths[node] <= 0;
  }
  return is_free;
}

std::vector<PlanePolygon> open_parts(const Planes& planes, const BspTree& tree, const BspPortal& portal) {
  std::vector<PlanePolygon> open{portal.polygon};
  for (const std::uint32_t number : portal.faces) {
    const FacePiece& face = tree.faces[number];
    if (!face.sheet) continue;
    std::vector<PlanePolygon> rest;
    for (PlanePolygon& part : open) {
      if (intersection(planes, part, face.polygon).empty()) {
        rest.push_back(std::move(part));
        continue;
      }
      for (const PlanePolygon::Side& side : face.polygon.sides) {
        if (!sides_of(planes, part, side.half.plane).both()) continue;
        SplitPolygon parts = split(planes, std::move(part), side.half.plane);
        if (side.half.turned) std::swap(parts.behind, parts.in_front);
        part = std::move(parts.behind);
        rest.push_back(std::move(parts.in_front));
      }
    }
    open = std::move(rest);
  }
  return open;
}

}  // namespace sightline::scene
