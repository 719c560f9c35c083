// See face.hpp. The outline is cut into strips between successive coordinates u. The spans of v that a strip
// covers are a sorted list of borders, and every side parallel to v toggles its two ends in it. Consecutive
// strips that cover the same span of v are one rectangle.
#include "host/scene/cells/grid/face.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <span>
#include <utility>

namespace sightline::scene {
namespace {

using geometry::Rectangle;
using geometry::Span;

template <class Visit>
void for_each_ring(const PolyFace& face, Visit visit) {
  visit(face.outline);
  for (const auto& hole : face.holes) visit(hole);
}

template <class Visit>
void for_each_side(const PolyScene& scene, const PolyFace& face, Visit visit) {
  for_each_ring(face, [&](std::span<const VertexIndex> ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      visit(scene.vertices[ring[i]], scene.vertices[ring[i + 1 == ring.size() ? 0 : i + 1]]);
    }
  });
}

struct Side {
  std::int32_t u = 0;
  Span v;
};

void toggle(std::vector<std::int32_t>& borders, std::int32_t v) {
  const auto place = std::lower_bound(borders.begin(), borders.end(), v);
  if (place != borders.end() && *place == v) {
    borders.erase(place);
  } else {
    borders.insert(place, v);
  }
}

// A span of v that has been covered since u = from.
struct Run {
  Span v;
  std::int32_t from = 0;
};

// The runs after u: those that continue, and new ones. A run that ends becomes a rectangle.
std::vector<Run> next_runs(const std::vector<Run>& before, const std::vector<std::int32_t>& borders,
                           std::int32_t u, GridFace& face) {
  std::vector<Run> runs;
  auto old = before.begin();
  const auto end = [&](const Run& run) {
    face.rectangles.push_back({face.axis, face.at, {Span{run.from, u}, run.v}});
  };
  for (std::size_t i = 0; i + 1 < borders.size(); i += 2) {
    const Span v{borders[i], borders[i + 1]};
    while (old != before.end() && old->v.low < v.low) end(*old++);
    if (old != before.end() && old->v == v) {
      runs.push_back(*old++);
    } else {
      runs.push_back({v, u});
    }
  }
  while (old != before.end()) end(*old++);
  return runs;
}

// Twice the area of the outline in (u, v), u and v ascending axes.
std::int64_t outline_area(const PolyScene& scene, const PolyFace& face, std::size_t u, std::size_t v) {
  std::int64_t area = 0;
  for (std::size_t i = 0; i < face.outline.size(); ++i) {
    const PolyPoint& a = scene.vertices[face.outline[i]];
    const PolyPoint& b = scene.vertices[face.outline[i + 1 == face.outline.size() ? 0 : i + 1]];
    area += std::int64_t{a[u]} * b[v] - std::int64_t{a[v]} * b[u];
  }
  return area;
}

}  // namespace

std::optional<std::size_t> grid_axis_of(const PolyScene& scene, const PolyFace& face) {
  std::array<bool, 3> constant{true, true, true};
  const PolyPoint& first = scene.vertices[face.outline[0]];
  for (const VertexIndex vertex : face.outline)
    for (std::size_t a = 0; a < 3; ++a) constant[a] = constant[a] && scene.vertices[vertex][a] == first[a];
  for (std::size_t a = 0; a < 3; ++a)
    if (constant[a]) return a;
  return std::nullopt;
}

bool has_grid_sides(const PolyScene& scene, const PolyFace& face) {
  bool parallel = true;
  for_each_side(scene, face, [&](const PolyPoint& a, const PolyPoint& b) {
    const int changed = (a[0] != b[0] ? 1 : 0) + (a[1] != b[1] ? 1 : 0) + (a[2] != b[2] ? 1 : 0);
    parallel = parallel && changed <= 1;
  });
  return parallel;
}

GridFace grid_face_of(const PolyScene& scene, const PolyFace& face) {
  GridFace result;
  result.axis = grid_axis_of(scene, face).value();
  result.at = scene.vertices[face.outline[0]][result.axis];
  const auto [u, v] = geometry::other_axes(result.axis);
  // (u, v) is the cyclic order of the plane's axes, except on y, where x comes before z.
  result.faces_up = (outline_area(scene, face, u, v) > 0) != (result.axis == 1);
  std::vector<Side> sides;
  for_each_side(scene, face, [&, u = u, v = v](const PolyPoint& a, const PolyPoint& b) {
    if (a[v] != b[v]) sides.push_back({a[u], {std::min(a[v], b[v]), std::max(a[v], b[v])}});
  });
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.u < b.u; });
  std::vector<std::int32_t> borders;
  std::vector<Run> runs;
  for (std::size_t i = 0; i < sides.size();) {
    const std::int32_t here = sides[i].u;
    for (; i < sides.size() && sides[i].u == here; ++i) {
      toggle(borders, sides[i].v.low);
      toggle(borders, sides[i].v.high);
    }
    runs = next_runs(runs, borders, here, result);
  }
  assert(borders.empty());
  return result;
}

}  // namespace sightline::scene
