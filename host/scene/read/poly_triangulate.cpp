// See poly_triangulate.hpp.
#include "host/scene/read/poly_triangulate.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "host/geometry/predicates.hpp"

namespace sightline::scene {
namespace {

using geometry::Point2;

struct EarCorner {
  VertexIndex vertex = 0;
  Point2 at{};
};
using Corners = std::vector<EarCorner>;

const EarCorner& after(const Corners& ring, std::size_t i) {
  return ring[i + 1 == ring.size() ? 0 : i + 1];
}

// p is in the closed triangle a, b, c, which turns counterclockwise.
bool in_triangle(const Point2& a, const Point2& b, const Point2& c, const Point2& p) {
  return geometry::turn(a, b, p) >= 0 && geometry::turn(b, c, p) >= 0 && geometry::turn(c, a, p) >= 0;
}

bool is_ear(const Corners& ring, std::size_t i) {
  const EarCorner& a = ring[i == 0 ? ring.size() - 1 : i - 1];
  const EarCorner& b = ring[i];
  const EarCorner& c = after(ring, i);
  if (geometry::turn(a.at, b.at, c.at) <= 0) return false;
  return std::none_of(ring.begin(), ring.end(), [&](const EarCorner& other) {
    return other.at != a.at && other.at != b.at && other.at != c.at &&
           in_triangle(a.at, b.at, c.at, other.at);
  });
}

// The open bridge p, q meets the ring's edge a, b elsewhere than in its own ends.
bool obstructs(const Point2& p, const Point2& q, const Point2& a, const Point2& b) {
  const bool joined = a == p || a == q || b == p || b == q;
  if (!joined) return geometry::segments_meet(p, q, a, b);
  const Point2& free = a == p || a == q ? b : a;
  if (free == p || free == q) return true;  // along a side
  const Point2& common = &free == &b ? a : b;
  const Point2& far = common == p ? q : p;
  return geometry::on_segment(p, q, free) || geometry::on_segment(a, b, far);
}

// The bridge leaves corner i of a counterclockwise ring into its inside.
bool leaves_inwards(const Corners& ring, std::size_t i, const Point2& to) {
  const Point2& before = ring[i == 0 ? ring.size() - 1 : i - 1].at;
  const Point2& here = ring[i].at;
  const Point2& next = after(ring, i).at;
  const bool left_of_next = geometry::turn(here, next, to) > 0;
  const bool left_of_before = geometry::turn(before, here, to) > 0;
  return geometry::turn(before, here, next) > 0 ? left_of_next && left_of_before
                                                : left_of_next || left_of_before;
}

// Joins the hole, one of `holes`, to the ring by a bridge passed twice. False if there is none.
bool join(Corners& ring, const Corners& hole, const std::vector<Corners>& holes) {
  const std::size_t start = static_cast<std::size_t>(
      std::max_element(hole.begin(), hole.end(),
                       [](const EarCorner& a, const EarCorner& b) { return a.at < b.at; }) -
      hole.begin());
  const Point2& from = hole[start].at;
  const auto blocked_by = [&](const Corners& edges, const Point2& to) {
    for (std::size_t e = 0; e < edges.size(); ++e)
      if (obstructs(from, to, edges[e].at, after(edges, e).at)) return true;
    return false;
  };
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2 to = ring[i].at;
    if (!leaves_inwards(ring, i, from) || blocked_by(ring, to)) continue;
    if (std::any_of(holes.begin(), holes.end(), [&](const Corners& o) { return blocked_by(o, to); }))
      continue;
    Corners bridge;
    for (std::size_t k = 0; k <= hole.size(); ++k) bridge.push_back(hole[(start + k) % hole.size()]);
    bridge.push_back(ring[i]);
    ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(i) + 1, bridge.begin(), bridge.end());
    return true;
  }
  return false;
}

// Joins a hole that shares a point with the ring at that point. False if there is none.
bool join_at_common_point(Corners& ring, const Corners& hole) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    for (std::size_t k = 0; k < hole.size(); ++k) {
      if (ring[i].at != hole[k].at || !leaves_inwards(ring, i, after(hole, k).at)) continue;
      Corners loop;
      for (std::size_t n = 1; n <= hole.size(); ++n) loop.push_back(hole[(k + n) % hole.size()]);
      ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(i) + 1, loop.begin(), loop.end());
      return true;
    }
  }
  return false;
}

Corners corners_of(const std::vector<PolyPoint>& vertices, std::span<const VertexIndex> ring,
                   std::size_t axis, bool turned) {
  Corners corners;
  for (const VertexIndex v : ring) corners.push_back({v, geometry::flattened(vertices[v], axis)});
  if (turned) std::reverse(corners.begin(), corners.end());
  return corners;
}

// Is a vertex so near to the segment, and between its ends, that it lies on it but for rounding? Each of the three was rounded
// by less than a step.
bool is_on_but_for_rounding(const Point2& from, const Point2& to, const Point2& p) {
  constexpr double nearest = 2;
  std::array<double, 2> along{};
  std::array<double, 2> way{};
  for (std::size_t i = 0; i < 2; ++i) {
    along[i] = double(to[i]) - from[i];
    way[i] = double(p[i]) - from[i];
  }
  const double square = along[0] * along[0] + along[1] * along[1];
  const double foot = along[0] * way[0] + along[1] * way[1];
  const double off = along[0] * way[1] - along[1] * way[0];
  return foot > 0 && foot < square && off * off <= nearest * nearest * square;
}

// Does cutting this corner off leave the vertices on one side of a face together? The segment that cuts it off is no diagonal
// if it lies on such a side: the face beyond may have the whole side as its edge.
bool cuts_through_inside(const Corners& ring, std::size_t i) {
  const EarCorner& a = ring[i == 0 ? ring.size() - 1 : i - 1];
  const EarCorner& c = after(ring, i);
  const auto is_on = [&](const EarCorner& other) { return is_on_but_for_rounding(a.at, c.at, other.at); };
  return !is_on(ring[i]) && std::none_of(ring.begin(), ring.end(), is_on);
}

std::optional<std::vector<std::array<VertexIndex, 3>>> clip_ears(Corners ring) {
  std::vector<std::array<VertexIndex, 3>> triangles;
  std::size_t at = 0;
  while (ring.size() >= 3) {
    if (at >= ring.size()) at = 0;
    // From here on the first ear that cuts through the inside; of a ring as thin as rounding the first one.
    std::optional<std::size_t> ear;
    for (const bool any : {false, true}) {
      for (std::size_t tried = 0; tried < ring.size() && !ear; ++tried) {
        const std::size_t i = (at + tried) % ring.size();
        if ((any || ring.size() == 3 || cuts_through_inside(ring, i)) && is_ear(ring, i)) ear = i;
      }
    }
    if (!ear) return std::nullopt;
    at = *ear;
    const EarCorner& before = ring[at == 0 ? ring.size() - 1 : at - 1];
    triangles.push_back({before.vertex, ring[at].vertex, after(ring, at).vertex});
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(at));
    if (ring.size() == 2) break;
  }
  return triangles;
}

// Of the face seen along an axis, in whose direction its area is not 0.
std::optional<std::vector<std::array<VertexIndex, 3>>> triangulate_along(std::size_t axis, bool turned,
                                                                         const std::vector<PolyPoint>& vertices,
                                                                         const PolyFace& face) {
  Corners ring = corners_of(vertices, face.outline, axis, turned);
  std::vector<Corners> holes;
  for (const auto& hole : face.holes) {
    if (hole.size() < 3) return std::nullopt;
    holes.push_back(corners_of(vertices, hole, axis, turned));
  }
  // A hole may have to wait until the one that hides the outline from it is joined.
  while (!holes.empty()) {
    auto joined = std::find_if(holes.begin(), holes.end(), [&](const Corners& hole) { return join_at_common_point(ring, hole); });
    if (joined == holes.end())
      joined = std::find_if(holes.begin(), holes.end(), [&](const Corners& hole) { return join(ring, hole, holes); });
    if (joined == holes.end()) return std::nullopt;
    holes.erase(joined);
  }
  auto triangles = clip_ears(std::move(ring));
  if (triangles && turned)
    for (auto& triangle : *triangles) std::swap(triangle[1], triangle[2]);
  return triangles;
}

}  // namespace

std::array<std::int64_t, 3> ring_normal(const std::vector<PolyPoint>& vertices,
                                        std::span<const VertexIndex> ring) {
  geometry::Vector3 sum{};
  for (std::size_t i = 2; i < ring.size(); ++i) {
    const auto part = geometry::normal_of(vertices[ring[0]], vertices[ring[i - 1]], vertices[ring[i]]);
    for (std::size_t a = 0; a < 3; ++a) sum[a] += part[a];
  }
  return sum;
}

std::optional<std::vector<std::array<VertexIndex, 3>>> triangulate(const std::vector<PolyPoint>& vertices, const PolyFace& face,
                                                                   std::size_t most_with_holes) {
  std::size_t count = face.outline.size();
  for (const auto& hole : face.holes) count += hole.size();
  const std::size_t most = face.holes.empty() ? most_split_vertices : most_with_holes;
  if (count > most || face.outline.size() < 3) return std::nullopt;
  const auto normal = ring_normal(vertices, face.outline);
  const std::size_t largest = geometry::dominant_axis(normal);
  if (normal[largest] == 0) return std::nullopt;
  const auto along = [&](std::size_t axis) { return triangulate_along(axis, normal[axis] < 0, vertices, face); };
  auto triangles = along(largest);
  // A warped face may be simple in another direction. A planar one seen nearly edge-on may seem so by rounding alone.
  constexpr std::int64_t least_share = 16;
  for (std::size_t axis = 0; axis < 3 && !triangles; ++axis) {
    const bool is_large = std::abs(normal[axis]) >= std::abs(normal[largest]) / least_share && normal[axis] != 0;
    if (axis != largest && is_large) triangles = along(axis);
  }
  return triangles;
}

}  // namespace sightline::scene
