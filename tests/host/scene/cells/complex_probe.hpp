// Tests a complex from outside, by points and straight lines through it, with independent arithmetic: checks of a decomposition
// without
// knowledge of the algorithm.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "host/geometry/predicates.hpp"
#include "host/geometry/rational.hpp"
#include "host/scene/model/cell_complex.hpp"
#include "host/scene/model/poly_scene.hpp"
#include "host/scene/read/poly_triangulate.hpp"

namespace sightline::scene {

using geometry::Rational;

struct Segment {
  PolyPoint from{};
  PolyPoint to{};
};

// The position of a segment in an interval of its parameter.
struct Stretch {
  Rational low{0};
  Rational high{1};

  [[nodiscard]] bool has_length() const { return low < high; }
};

// The part of the segment in closed half-spaces.
inline Stretch stretch_in(const CellComplex& complex, std::span<const HalfSpace> halves,
                          const Segment& segment) {
  Stretch stretch;
  for (const HalfSpace& half : halves) {
    const geometry::Plane& plane = complex.planes[half.plane];
    const std::int64_t from = half.turned ? -plane.at(segment.from) : plane.at(segment.from);
    const std::int64_t to = half.turned ? -plane.at(segment.to) : plane.at(segment.to);
    if (from > 0 && to > 0) return {Rational(1), Rational(0)};
    if (from == to) {
      if (from > 0) return {Rational(1), Rational(0)};
      continue;
    }
    const Rational cut(from, from - to);
    if (from < to) {
      stretch.high = std::min(stretch.high, cut);
    } else {
      stretch.low = std::max(stretch.low, cut);
    }
  }
  return stretch;
}

struct SceneTriangle {
  std::array<PolyPoint, 3> corners;
  bool sheet = false;
};

inline std::vector<SceneTriangle> triangles_of(const PolyScene& scene) {
  std::vector<SceneTriangle> triangles;
  for (const PolyBody& body : scene.bodies) {
    for (const PolyFace& face : body.faces) {
      const auto parts = triangulate(scene.vertices, face);
      if (!parts) continue;
      for (const auto& [a, b, c] : *parts)
        triangles.push_back({{scene.vertices[a], scene.vertices[b], scene.vertices[c]}, body.sheet});
    }
  }
  return triangles;
}

// 1: the segment crosses the triangle against its normal, into a solid; -1: out of one; 0: it misses the triangle. Nothing if it
// touches
// the boundary or the plane, where the result is uncertain.
inline std::optional<int> crossing(const SceneTriangle& triangle, const Segment& segment) {
  const auto& [a, b, c] = triangle.corners;
  const int from = geometry::sign(geometry::orientation(a, b, c, segment.from));
  const int to = geometry::sign(geometry::orientation(a, b, c, segment.to));
  if (from == 0 || to == 0) return std::nullopt;
  if (from == to) return 0;
  const auto side = [&](const PolyPoint& p, const PolyPoint& q) {
    return geometry::sign(geometry::orientation(segment.from, segment.to, p, q));
  };
  const int ab = side(a, b);
  const int bc = side(b, c);
  const int ca = side(c, a);
  if ((ab > 0 || bc > 0 || ca > 0) && (ab < 0 || bc < 0 || ca < 0)) return 0;
  if (ab == 0 || bc == 0 || ca == 0) return std::nullopt;
  return from > 0 ? 1 : -1;
}

}  // namespace sightline::scene
