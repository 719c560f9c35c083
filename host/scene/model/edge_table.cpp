// See edge_table.hpp.
#include "host/scene/model/edge_table.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>

namespace sightline::scene {
namespace {

constexpr std::uint32_t no_face = std::numeric_limits<std::uint32_t>::max();

// Sides of faces, and wires as those of no face.
template <class Visit>
void for_sides(const PolyScene& scene, Visit visit) {
  std::uint32_t number = 0;
  const auto ring = [&](std::span<const VertexIndex> vertices) {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const VertexIndex from = vertices[i];
      const VertexIndex to = vertices[i + 1 == vertices.size() ? 0 : i + 1];
      if (from != to) visit(from, to, number);
    }
  };
  for (const PolyBody& body : scene.bodies) {
    for (const PolyFace& face : body.faces) {
      ring(face.outline);
      for (const auto& hole : face.holes) ring(hole);
      ++number;
    }
  }
  for (const auto& [from, to] : scene.wires)
    if (from != to) visit(from, to, no_face);
}

struct UpperEnd {  // of a side
  VertexIndex high = 0;
  EdgeTable::Use use;
};

}  // namespace

// Sides sorted by their lower vertex by counting, then by the higher within the few of one vertex.
EdgeTable::EdgeTable(const PolyScene& scene) {
  std::vector<std::uint32_t> start(scene.vertices.size() + 1);
  for_sides(scene, [&](VertexIndex from, VertexIndex to, std::uint32_t) { ++start[std::min(from, to) + 1]; });
  for (std::size_t v = 1; v < start.size(); ++v) start[v] += start[v - 1];
  std::vector<UpperEnd> sides(start.back());
  std::vector<std::uint32_t> fill(start.begin(), start.end() - 1);
  for_sides(scene, [&](VertexIndex from, VertexIndex to, std::uint32_t face) {
    sides[fill[std::min(from, to)]++] = {std::max(from, to), {face, from < to}};
  });
  edges_.reserve(sides.size() / 2 + 2);
  uses_.reserve(sides.size());
  for (VertexIndex v = 0; v + 1 < start.size(); ++v) {
    UpperEnd* const begin = sides.data() + start[v];
    UpperEnd* const end = sides.data() + start[v + 1];
    std::sort(begin, end, [](const UpperEnd& a, const UpperEnd& b) {
      if (a.high != b.high) return a.high < b.high;
      return a.use.face != b.use.face ? a.use.face < b.use.face : a.use.upwards < b.use.upwards;
    });
    for (const UpperEnd* side = begin; side != end; ++side) {
      if (side == begin || side->high != (side - 1)->high)
        edges_.push_back({v, side->high, static_cast<std::uint32_t>(uses_.size())});
      if (side->use.face != no_face) uses_.push_back(side->use);
    }
  }
  edges_.push_back({0, 0, static_cast<std::uint32_t>(uses_.size())});
}

std::size_t EdgeTable::find(VertexIndex a, VertexIndex b) const {
  const auto [low, high] = std::minmax(a, b);
  const auto end = edges_.end() - 1;
  const auto found = std::lower_bound(edges_.begin(), end, std::pair(low, high), [](const Edge& edge, const auto& ends) {
    return std::pair(edge.low, edge.high) < ends;
  });
  return found != end && found->low == low && found->high == high ? static_cast<std::size_t>(found - edges_.begin()) : size();
}

}  // namespace sightline::scene
