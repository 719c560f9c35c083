// See decompose.hpp.
#include "host/scene/cells/bsp/decompose.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/base/result.hpp"
#include "host/geometry/rational.hpp"
#include "host/scene/cells/bsp/join.hpp"
#include "host/scene/cells/bsp/space.hpp"
#include "host/scene/cells/bsp/tree.hpp"
#include "host/scene/cells/builder.hpp"

namespace sightline::scene {
namespace {

using geometry::Rational;

class ComplexMaker {
 public:
  ComplexMaker(CellComplexBuilder& builder, BspTree& tree) : builder_(builder), tree_(tree) {}

  void make(bool join) {
    const std::vector<bool> is_free = free_leaves(planes(), tree_);
    cells_.assign(tree_.nodes.size(), outside);
    std::vector<std::uint32_t> part_of(tree_.nodes.size());
    std::iota(part_of.begin(), part_of.end(), std::uint32_t{0});
    if (join) part_of = join_leaves(builder_, is_free, tree_);
    for (std::uint32_t node = 0; node < tree_.nodes.size(); ++node) {
      if (!is_free[node]) continue;
      if (part_of[node] == node) cells_[node] = builder_.add_cell(bounds_of(tree_, node));
    }
    for (std::uint32_t node = 0; node < tree_.nodes.size(); ++node) cells_[node] = cells_[part_of[node]];
    for (const BspPortal& portal : tree_.portals) add_openings(portal);
    for (std::uint32_t edge = 0; edge < builder_.complex().edges.size(); ++edge) add_lines(edge);
  }

 private:
  [[nodiscard]] const Planes& planes() const { return builder_.complex().planes; }

  [[nodiscard]] bool is_open(std::uint32_t node) const { return node == no_node || cells_[node] != outside; }

  void add_openings(const BspPortal& portal) {
    if (portal.polygon.empty()) return;
    if (!is_open(portal.nodes[0]) || !is_open(portal.nodes[1])) return;
    const auto cell = [&](std::uint32_t node) { return node == no_node ? outside : cells_[node]; };
    std::vector<HalfSpace> sides;
    for (const PlanePolygon& part : open_parts(planes(), tree_, portal)) {
      sides.clear();
      for (const PlanePolygon::Side& side : part.sides) sides.push_back(side.half);
      builder_.add_opening({part.plane, false}, cell(portal.nodes[0]), cell(portal.nodes[1]), sides);
    }
  }

  struct EdgePart {
    std::uint32_t place = 0;  // a node, or a cell
    Rational low;
    Rational high;
  };

  // Passes an edge down the tree; an edge in a node's plane goes into both children.
  void add_lines(std::uint32_t edge) {
    const ComplexEdge ends = builder_.complex().edges[edge];
    const PolyPoint from = builder_.complex().vertices[ends.from];
    const PolyPoint to = builder_.complex().vertices[ends.to];
    in_cells_.clear();
    parts_.assign(1, {0, Rational(0), Rational(1)});
    while (!parts_.empty()) {
      const EdgePart part = parts_.back();
      parts_.pop_back();
      const BspNode& node = tree_.nodes[part.place];
      if (!node.is_leaf()) {
        split_part(part, node, planes()[node.plane].at(from), planes()[node.plane].at(to));
      } else if (cells_[part.place] != outside) {
        in_cells_.push_back({cells_[part.place], part.low, part.high});
      }
    }
    add_united_lines(edge);
  }

  // A cell may consist of several leaves. It is convex, so its part of an edge is one interval.
  void add_united_lines(std::uint32_t edge) {
    std::sort(in_cells_.begin(), in_cells_.end(),
              [](const EdgePart& a, const EdgePart& b) { return a.place < b.place; });
    for (std::size_t i = 0; i < in_cells_.size();) {
      EdgePart whole = in_cells_[i];
      for (++i; i < in_cells_.size() && in_cells_[i].place == whole.place; ++i) {
        whole.low = std::min(whole.low, in_cells_[i].low);
        whole.high = std::max(whole.high, in_cells_[i].high);
      }
      builder_.add_line(whole.place, edge, whole.low, whole.high);
    }
  }

  // `from` and `to` are the values of the node's plane at the ends of the edge.
  void split_part(const EdgePart& part, const BspNode& node, std::int64_t from, std::int64_t to) {
    if (from == to) {
      if (from <= 0) parts_.push_back({node.children[0], part.low, part.high});
      if (from >= 0) parts_.push_back({node.children[1], part.low, part.high});
      return;
    }
    const Rational cut(from, from - to);
    const Rational first_end = std::min(part.high, cut);
    const Rational last_start = std::max(part.low, cut);
    const bool upwards = from < to;
    if (part.low < first_end) parts_.push_back({node.children[upwards ? 0 : 1], part.low, first_end});
    if (last_start < part.high) parts_.push_back({node.children[upwards ? 1 : 0], last_start, part.high});
  }

  CellComplexBuilder& builder_;
  BspTree& tree_;
  std::vector<CellNumber> cells_;   // by node
  std::vector<EdgePart> parts_;     // of one edge, by node, not yet passed to the leaves
  std::vector<EdgePart> in_cells_;  // of one edge, by cell
};

}  // namespace

base::Result<CellComplex> decompose_bsp(const PolyScene& scene, const BspOptions& options) {
  const bool has_face = std::any_of(scene.bodies.begin(), scene.bodies.end(),
                                    [](const PolyBody& body) { return !body.faces.empty(); });
  if (!has_face) return base::Error{"", "", "found no face", "at least one"};
  CellComplexBuilder builder(scene, outer_box_of(scene));
  std::optional<BspTree> tree = build_bsp_tree(face_pieces(scene, builder), builder, options.most_leaves);
  if (!tree) {
    return base::Error{"", "",
                       "the planes of the faces cut space into more than " +
                           std::to_string(options.most_leaves) + " cells"};
  }
  ComplexMaker(builder, *tree).make(options.join);
  return builder.take();
}

}  // namespace sightline::scene
