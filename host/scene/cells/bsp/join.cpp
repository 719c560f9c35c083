// See join.hpp.
#include "host/scene/cells/bsp/join.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace sightline::scene {
namespace {

class LeafJoiner {
 public:
  LeafJoiner(CellComplexBuilder& builder, const std::vector<bool>& is_free, BspTree& tree)
      : builder_(builder), is_free_(is_free), tree_(tree), part_of_(tree.nodes.size()) {
    std::iota(part_of_.begin(), part_of_.end(), std::uint32_t{0});
  }

  std::vector<std::uint32_t> join_all() {
    for (bool joined = true; joined;) {
      joined = false;
      for (std::uint32_t number = 0; number < tree_.portals.size(); ++number) {
        joined = try_to_join(number) || joined;
      }
    }
    for (std::uint32_t& part : part_of_) {
      while (part_of_[part] != part) part = part_of_[part];
    }
    return std::move(part_of_);
  }

 private:
  [[nodiscard]] const Planes& planes() const { return builder_.complex().planes; }

  bool try_to_join(std::uint32_t number) {
    const BspPortal& portal = tree_.portals[number];
    const auto [behind, in_front] = portal.nodes;
    if (portal.polygon.empty() || behind == no_node || in_front == no_node) return false;
    if (!is_free_[behind] || !is_free_[in_front]) return false;
    const std::uint32_t plane = portal.polygon.plane;
    if (!has_single_portal(behind, plane) || !has_single_portal(in_front, plane) || !is_open(portal)) return false;
    const std::vector<HalfSpace> behind_bounds = bounds_without(behind, plane);
    if (!is_within(in_front, behind_bounds)) return false;
    const std::vector<HalfSpace> front_bounds = bounds_without(in_front, plane);
    if (!is_within(behind, front_bounds)) return false;
    join(behind, in_front, number);
    return true;
  }

  // Whether the leaf has only one portal in the plane. If it has more, its face there is larger than the
  // other leaf's.
  [[nodiscard]] bool has_single_portal(std::uint32_t node, std::uint32_t plane) const {
    const std::vector<std::uint32_t>& portals = tree_.portals_of[node];
    return std::count_if(portals.begin(), portals.end(), [&](std::uint32_t number) {
             return tree_.portals[number].polygon.plane == plane;
           }) == 1;
  }

  // Whether no sheet covers any part of the portal.
  [[nodiscard]] bool is_open(const BspPortal& portal) const {
    return std::none_of(portal.faces.begin(), portal.faces.end(), [&](std::uint32_t number) {
      const FacePiece& face = tree_.faces[number];
      return face.sheet && !intersection(planes(), portal.polygon, face.polygon).empty();
    });
  }

  [[nodiscard]] std::vector<HalfSpace> bounds_without(std::uint32_t node, std::uint32_t plane) const {
    std::vector<HalfSpace> bounds = bounds_of(tree_, node);
    std::erase_if(bounds, [&](const HalfSpace& bound) { return bound.plane == plane; });
    return bounds;
  }

  // Whether every corner of the leaf is in these half-spaces. Its corners are the corners of its portals.
  [[nodiscard]] bool is_within(std::uint32_t node, const std::vector<HalfSpace>& bounds) const {
    return std::all_of(bounds.begin(), bounds.end(), [&](const HalfSpace& bound) {
      const std::vector<std::uint32_t>& portals = tree_.portals_of[node];
      return std::all_of(portals.begin(), portals.end(), [&](std::uint32_t number) {
        const PolygonSides sides = sides_of(planes(), tree_.portals[number].polygon, bound.plane);
        return bound.turned ? !sides.behind : !sides.in_front;
      });
    });
  }

  // The leaf or the outside that a portal of `node` leads to. Outside is not convex, so the portal's plane
  // counts, too.
  struct Way {
    std::uint32_t other = 0;
    std::uint32_t plane = 0;
    std::uint32_t portal = 0;

    [[nodiscard]] bool same_as(const Way& way) const { return other == way.other && plane == way.plane; }
  };

  // Adds the portals of `gone` to `kept`; `between` is the portal between them.
  void join(std::uint32_t kept, std::uint32_t gone, std::uint32_t between) {
    std::vector<Way> ways;
    for (const std::uint32_t node : {kept, gone}) {
      for (const std::uint32_t number : std::exchange(tree_.portals_of[node], {})) {
        if (number == between) continue;
        BspPortal& portal = tree_.portals[number];
        const std::size_t end = portal.nodes[0] == node ? 0 : 1;
        portal.nodes[end] = kept;
        ways.push_back({portal.nodes[1 - end], portal.polygon.plane, number});
      }
    }
    part_of_[gone] = kept;
    tree_.portals[between].polygon.sides.clear();
    std::sort(ways.begin(), ways.end(), [](const Way& a, const Way& b) {
      return std::tie(a.other, a.plane, a.portal) < std::tie(b.other, b.plane, b.portal);
    });
    for (const Way& way : ways) tree_.portals_of[kept].push_back(way.portal);
    const std::vector<HalfSpace> bounds = bounds_of(tree_, kept);
    for (std::size_t i = 1; i < ways.size(); ++i) {
      if (ways[i].same_as(ways[i - 1])) unite(ways[i - 1], ways[i], bounds);
    }
  }

  // Unites two portals that lead from a leaf with these bounds to the same neighbour: the first becomes both.
  void unite(const Way& way, const Way& removed, const std::vector<HalfSpace>& bounds) {
    BspPortal& first = tree_.portals[way.portal];
    BspPortal& second = tree_.portals[removed.portal];
    PlanePolygon polygon = common_polygon(way, bounds);
    first.polygon = std::move(polygon);
    first.faces.insert(first.faces.end(), second.faces.begin(), second.faces.end());
    std::sort(first.faces.begin(), first.faces.end());
    first.faces.erase(std::unique(first.faces.begin(), first.faces.end()), first.faces.end());
    second.polygon.sides.clear();
    for (const std::uint32_t node : second.nodes) {
      if (node != no_node) std::erase(tree_.portals_of[node], removed.portal);
    }
  }

  // The common part of both leaves in the plane; to the outside, the leaf's part of the outer box's surface.
  [[nodiscard]] PlanePolygon common_polygon(const Way& way, const std::vector<HalfSpace>& bounds) {
    PlanePolygon polygon = widest_polygon(builder_, way.plane);
    const auto clip = [&](const std::vector<HalfSpace>& halves) {
      for (const HalfSpace& half : halves) {
        if (half.plane != way.plane) polygon = clip_to(planes(), std::move(polygon), half);
      }
    };
    clip(bounds);
    if (way.other != no_node) clip(bounds_of(tree_, way.other));
    return polygon;
  }

  CellComplexBuilder& builder_;
  const std::vector<bool>& is_free_;
  BspTree& tree_;
  std::vector<std::uint32_t> part_of_;
};

}  // namespace

std::vector<std::uint32_t> join_leaves(CellComplexBuilder& builder, const std::vector<bool>& is_free,
                                       BspTree& tree) {
  return LeafJoiner(builder, is_free, tree).join_all();
}

}  // namespace sightline::scene
