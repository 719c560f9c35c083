#include "host/algorithms/skala/figure_box.hpp"

#include <cmath>
#include <cstddef>

namespace sightline::algorithms::skala {
namespace {

BoxPoint between(const BoxPoint& a, const BoxPoint& b, double t) {
  BoxPoint point = a;
  for (std::size_t i = 0; i < 3; ++i)
    if (a[i] != b[i]) point[i] = t == 1 ? b[i] : a[i] + t * (b[i] - a[i]);
  return point;
}

Vertex placed(const Surface& surface, const BoxPoint& point) {
  return surface.place(point[0], point[1], point[2]);
}

}  // namespace

std::vector<BoxEdge> visible_box(const Surface& surface, const Box& box, const Coverage* coverage) {
  const std::array<double, 3> eye = surface.to_eye();
  const auto side = [&](std::size_t axis, int sign) { return axis == 2 ? (sign < 0 ? box.low : box.high) : static_cast<double>(sign); };
  std::vector<BoxEdge> seen;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t other = (axis + 1) % 3;
    const std::size_t third = (axis + 2) % 3;
    for (const int a : {-1, 1})
      for (const int b : {-1, 1}) {
        const bool a_is_near = a * eye[other] > 0;
        const bool b_is_near = b * eye[third] > 0;
        if (a_is_near && b_is_near) continue;
        BoxEdge edge;
        edge.from[axis] = side(axis, -1);
        edge.to[axis] = side(axis, 1);
        edge.from[other] = edge.to[other] = side(other, a);
        edge.from[third] = edge.to[third] = side(third, b);
        if (a_is_near || b_is_near || coverage == nullptr) {
          seen.push_back(edge);
          continue;
        }
        for (const LinePart& part : coverage->visible(placed(surface, edge.from), placed(surface, edge.to)))
          seen.push_back({between(edge.from, edge.to, part.from), between(edge.from, edge.to, part.to)});
      }
  }
  return seen;
}

std::array<TickEdge, 3> tick_edges(const Surface& surface, const Box& box) {
  const std::array<double, 3> eye = surface.to_eye();
  // From above, the lower outline of the box consists of its nearer edges; from below, of its farther ones.
  const double lower = eye[2] < 0 ? -1 : 1;
  const double x_side = eye[0] == 0 ? 1 : (eye[0] * lower > 0 ? 1 : -1);
  const double z_side = eye[1] == 0 ? -1 : (eye[1] * lower > 0 ? 1 : -1);
  TickEdge x{{{-1, z_side, box.low}, {1, z_side, box.low}}, {0, z_side, 0}};
  TickEdge z{{{x_side, -1, box.low}, {x_side, 1, box.low}}, {x_side, 0, 0}};
  // The leftmost corner; of two, the lower one.
  BoxPoint corner{-1, -1, box.low};
  for (const double cx : {-1.0, 1.0})
    for (const double cz : {-1.0, 1.0}) {
      const auto here = surface.project(cx, cz, box.low);
      const auto best = surface.project(corner[0], corner[1], box.low);
      constexpr double same = 1e-9;
      if (here[0] < best[0] - same || (here[0] < best[0] + same && here[1] < best[1])) corner = {cx, cz, box.low};
    }
  BoxPoint top = corner;
  top[2] = box.high;
  return {x, z, TickEdge{{corner, top}, {0, 0, 0}}};
}

}  // namespace sightline::algorithms::skala
