// See tree.hpp.
#include "host/scene/cells/bsp/tree.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "host/scene/cells/bsp/choice.hpp"

namespace sightline::scene {
namespace {

class TreeGrower {
 public:
  explicit TreeGrower(CellComplexBuilder& builder) : builder_(builder) {}

  std::optional<BspTree> grow(std::vector<FacePiece> faces, std::size_t most_leaves) {
    add_node();
    faces_within_.back() = std::move(faces);
    enclose_root();
    std::size_t leaves = 1;
    // Breadth first: a part is split while the parts around it are still large, so that few portals are split.
    for (std::uint32_t node = 0; node < tree_.nodes.size(); ++node) {
      if (faces_within_[node].empty()) continue;
      split_node(node);
      if (++leaves > most_leaves) return std::nullopt;
    }
    return std::move(tree_);
  }

 private:
  [[nodiscard]] const Planes& planes() const { return builder_.complex().planes; }

  std::uint32_t add_node() {
    tree_.nodes.emplace_back();
    tree_.portals_of.emplace_back();
    faces_within_.emplace_back();
    return static_cast<std::uint32_t>(tree_.nodes.size() - 1);
  }

  void add_portal(PlanePolygon polygon, std::array<std::uint32_t, 2> nodes,
                  std::vector<std::uint32_t> faces) {
    const auto number = static_cast<std::uint32_t>(tree_.portals.size());
    tree_.portals.push_back({std::move(polygon), nodes, std::move(faces)});
    for (const std::uint32_t node : nodes)
      if (node != no_node) tree_.portals_of[node].push_back(number);
  }

  void enclose_root() {
    const geometry::Box outer = builder_.complex().outer;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::uint32_t low = builder_.at_least(axis, outer.low[axis]).plane;
      const std::uint32_t high = builder_.at_most(axis, outer.high[axis]).plane;
      add_portal(widest_polygon(builder_, low), {no_node, 0}, {});
      add_portal(widest_polygon(builder_, high), {0, no_node}, {});
    }
  }

  void split_node(std::uint32_t node) {
    std::vector<FacePiece> within = std::move(faces_within_[node]);
    faces_within_[node].clear();
    const std::uint32_t plane = splitting_plane(planes(), within);
    PlanePolygon cut = cut_through(node, plane);
    const std::array<std::uint32_t, 2> children{add_node(), add_node()};
    tree_.nodes[node].plane = plane;
    tree_.nodes[node].children = children;
    std::vector<std::uint32_t> in_plane = share_faces(within, plane, children);
    const std::vector<std::uint32_t> around = std::exchange(tree_.portals_of[node], {});
    for (const std::uint32_t portal : around) split_portal(portal, node, plane, children);
    add_portal(std::move(cut), children, std::move(in_plane));
  }

  // The part of a plane in a node, through whose inside it passes.
  PlanePolygon cut_through(std::uint32_t node, std::uint32_t plane) {
    PlanePolygon cut = widest_polygon(builder_, plane);
    for (const HalfSpace& bound : bounds_of(tree_, node)) {
      cut = clip_to(planes(), std::move(cut), bound);
    }
    assert(!cut.empty());
    return cut;
  }

  // Distributes the faces to the children. Those in the plane are kept for the new portal.
  std::vector<std::uint32_t> share_faces(std::vector<FacePiece>& within, std::uint32_t plane,
                                         const std::array<std::uint32_t, 2>& children) {
    std::vector<std::uint32_t> in_plane;
    for (FacePiece& face : within) {
      if (face.polygon.plane == plane) {
        in_plane.push_back(static_cast<std::uint32_t>(tree_.faces.size()));
        tree_.faces.push_back(std::move(face));
        continue;
      }
      SplitPolygon parts = split(planes(), std::move(face.polygon), plane);
      const auto give = [&](PlanePolygon& part, std::uint32_t child) {
        if (!part.empty()) faces_within_[child].push_back({std::move(part), face.sheet, face.turned});
      };
      give(parts.behind, children[0]);
      give(parts.in_front, children[1]);
    }
    return in_plane;
  }

  void split_portal(std::uint32_t number, std::uint32_t node, std::uint32_t plane,
                    const std::array<std::uint32_t, 2>& children) {
    const PolygonSides sides = sides_of(planes(), tree_.portals[number].polygon, plane);
    assert(sides.behind || sides.in_front);
    const std::size_t end = tree_.portals[number].nodes[0] == node ? 0 : 1;
    if (!sides.both()) {
      const std::uint32_t child = children[sides.behind ? 0 : 1];
      tree_.portals[number].nodes[end] = child;
      tree_.portals_of[child].push_back(number);
      return;
    }
    BspPortal& portal = tree_.portals[number];
    SplitPolygon parts = split(planes(), std::move(portal.polygon), plane);
    SplitFaces faces = faces_of_parts(portal.faces, plane);
    portal.polygon = std::move(parts.behind);
    portal.faces = std::move(faces.behind);
    portal.nodes[end] = children[0];
    tree_.portals_of[children[0]].push_back(number);
    std::array<std::uint32_t, 2> nodes = portal.nodes;
    nodes[end] = children[1];
    add_portal(std::move(parts.in_front), nodes, std::move(faces.in_front));
  }

  struct SplitFaces {
    std::vector<std::uint32_t> behind;
    std::vector<std::uint32_t> in_front;
  };

  [[nodiscard]] SplitFaces faces_of_parts(const std::vector<std::uint32_t>& faces,
                                          std::uint32_t plane) const {
    SplitFaces parts;
    for (const std::uint32_t face : faces) {
      const PolygonSides sides = sides_of(planes(), tree_.faces[face].polygon, plane);
      if (sides.behind) parts.behind.push_back(face);
      if (sides.in_front) parts.in_front.push_back(face);
    }
    return parts;
  }

  CellComplexBuilder& builder_;
  BspTree tree_;
  std::vector<std::vector<FacePiece>> faces_within_;  // by node, faces inside leaves still to be split
};

}  // namespace

std::vector<HalfSpace> bounds_of(const BspTree& tree, std::uint32_t node) {
  std::vector<HalfSpace> bounds;
  for (const std::uint32_t number : tree.portals_of[node]) {
    const BspPortal& portal = tree.portals[number];
    bounds.push_back({portal.polygon.plane, portal.nodes[1] == node});
  }
  const auto before = [](const HalfSpace& a, const HalfSpace& b) {
    return a.plane != b.plane ? a.plane < b.plane : a.turned < b.turned;
  };
  std::sort(bounds.begin(), bounds.end(), before);
  bounds.erase(std::unique(bounds.begin(), bounds.end()), bounds.end());
  return bounds;
}

std::optional<BspTree> build_bsp_tree(std::vector<FacePiece> faces, CellComplexBuilder& builder,
                                      std::size_t most_leaves) {
  return TreeGrower(builder).grow(std::move(faces), most_leaves);
}

}  // namespace sightline::scene
