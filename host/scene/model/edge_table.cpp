// See edge_table.hpp.
#include "host/scene/model/edge_table.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "host/base/threads.hpp"

namespace sightline::scene {
namespace {

constexpr std::uint32_t no_face = 0x7fffffff;

template <class Visit>
void for_ring(const Ring& ring, std::uint32_t face, Visit visit) {
  if (ring.empty()) return;
  VertexIndex from = ring.back();
  for (const VertexIndex to : ring) {
    if (from != to) visit(from, to, face);
    from = to;
  }
}

// A side as one number, by its upper end, its face and whether it is passed upwards: the order of uses.
constexpr std::uint64_t packed(VertexIndex high, std::uint32_t face, bool upwards) {
  return std::uint64_t{high} << 32U | std::uint64_t{face} << 1U | std::uint64_t{upwards};
}

void sort_few(std::uint64_t* begin, std::uint64_t* end) {
  constexpr std::ptrdiff_t few = 24;
  if (end - begin < 2) return;
  if (end - begin > few) {
    std::sort(begin, end);
    return;
  }
  for (std::uint64_t* i = begin + 1; i < end; ++i) {
    const std::uint64_t moved = *i;
    std::uint64_t* to = i;
    for (; to != begin && to[-1] > moved; --to) *to = to[-1];
    *to = moved;
  }
}

}  // namespace

EdgeTable::EdgeTable(const PolyScene& scene, unsigned jobs) {
  build(scene.vertices.size(), jobs, [&scene](auto visit) {
    std::uint32_t number = 0;
    for (const PolyBody& body : scene.bodies) {
      for (const PolyFace& face : body.faces) {
        for_ring(face.outline, number, visit);
        for (const Ring& hole : face.holes) for_ring(hole, number, visit);
        ++number;
      }
    }
    for (const auto& [from, to] : scene.wires)
      if (from != to) visit(from, to, no_face);
  });
}

EdgeTable::EdgeTable(std::size_t vertices, std::span<const Ring* const> outlines, unsigned jobs) {
  build(vertices, jobs, [outlines](auto visit) {
    for (std::uint32_t face = 0; face < outlines.size(); ++face) for_ring(*outlines[face], face, visit);
  });
}

// Sides sorted by their lower vertex by counting, then by the higher within the few of one vertex.
template <class ForSides>
void EdgeTable::build(std::size_t vertices, unsigned jobs, ForSides for_sides) {
  // Each thread has the sides of the lower vertices `begin` to `end` - 1.
  const auto for_sides_of = [&](std::size_t begin, std::size_t end, auto visit) {
    for_sides([&](VertexIndex from, VertexIndex to, std::uint32_t face) {
      const VertexIndex low = std::min(from, to);
      if (begin <= low && low < end) visit(low, packed(std::max(from, to), face, from < to));
    });
  };
  std::vector<std::uint32_t> start(vertices + 1);
  base::for_parts(jobs, vertices, [&](std::size_t, std::size_t begin, std::size_t end) {
    for_sides_of(begin, end, [&](VertexIndex low, std::uint64_t) { ++start[low]; });
  });
  std::uint32_t count = 0;
  for (std::uint32_t& s : start) s = std::exchange(count, count + s);
  std::vector<std::uint64_t> sides(count);
  base::for_parts(jobs, vertices, [&](std::size_t, std::size_t begin, std::size_t end) {
    if (begin == end) return;
    std::uint32_t first = start[begin];
    for_sides_of(begin, end, [&](VertexIndex low, std::uint64_t side) { sides[start[low]++] = side; });
    // Now start[v] is where the sides of v end.
    for (std::size_t v = begin; v < end; ++v) {
      sort_few(sides.data() + first, sides.data() + start[v]);
      first = start[v];
    }
  });
  edges_.reserve(count / 2 + 2);
  uses_.reserve(count);
  std::uint32_t begin = 0;
  for (VertexIndex v = 0; v < vertices; ++v) {
    for (std::uint32_t i = begin; i < start[v]; ++i) {
      const auto high = static_cast<VertexIndex>(sides[i] >> 32U);
      if (i == begin || high != static_cast<VertexIndex>(sides[i - 1] >> 32U))
        edges_.push_back({v, high, static_cast<std::uint32_t>(uses_.size())});
      const auto face = static_cast<std::uint32_t>(sides[i]) >> 1U;
      if (face != no_face) uses_.push_back({face & no_face, static_cast<std::uint32_t>(sides[i]) & 1U});
    }
    begin = start[v];
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
