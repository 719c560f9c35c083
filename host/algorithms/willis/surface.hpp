// A surface in the sense of Willis (1977): a convex piece of a face, seen from one side only.
//
// Points lie on a lattice of 2^-12 of a scene unit, so that an edge can be halved twelve times and everything stays an
// integer: coordinates below 2^30, squared distances below 2^64, a plane at a point below 2^75. Pieces are only cut at
// vertices, at middles of edges and at lattice points, and therefore stay exactly in the plane of their face.
//
// In plan (the paper's own setting: walls standing on the ground) a surface is a segment: two points with vertical
// coordinate 0, and the heights of the wall's foot and top.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/geometry/predicates.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::willis {

inline constexpr int lattice_bits = 12;
inline constexpr std::int32_t lattice_unit = 1 << lattice_bits;

using Point = std::array<std::int32_t, 3>;  // in lattice units
using geometry::Int128;
using geometry::Vector3;

[[nodiscard]] constexpr Point on_lattice(const scene::PolyPoint& p) {
  return {p[0] * lattice_unit, p[1] * lattice_unit, p[2] * lattice_unit};
}

// From b to a; components below 2^31.
[[nodiscard]] constexpr Vector3 between(const Point& a, const Point& b) {
  return {std::int64_t{a[0]} - b[0], std::int64_t{a[1]} - b[1], std::int64_t{a[2]} - b[2]};
}

[[nodiscard]] constexpr std::uint64_t squared_length(const Vector3& v) {
  return static_cast<std::uint64_t>(v[0] * v[0]) + static_cast<std::uint64_t>(v[1] * v[1]) +
         static_cast<std::uint64_t>(v[2] * v[2]);
}

[[nodiscard]] constexpr std::uint64_t squared_distance(const Point& a, const Point& b) {
  return squared_length(between(a, b));
}

// The plane of a face, positive on the side from which the face is seen. In scene units, the normal is below 2^40, the
// offset below 2^60.
struct SurfacePlane {
  Vector3 normal{};
  std::int64_t offset = 0;

  [[nodiscard]] constexpr Int128 at(const Point& p) const {
    return Int128{normal[0]} * p[0] + Int128{normal[1]} * p[1] + Int128{normal[2]} * p[2] -
           Int128{offset} * lattice_unit;
  }
  [[nodiscard]] constexpr int side(const Point& p) const { return geometry::sign(at(p)); }

  friend bool operator==(const SurfacePlane&, const SurfacePlane&) = default;
};

struct Surface {
  // Convex, without collinear points, counterclockwise as seen from the end of the normal; two points in plan.
  std::vector<Point> points;
  SurfacePlane plane;
  std::uint32_t face = 0;  // number in the scene, counted over all bodies
  std::uint32_t body = 0;
  std::uint32_t cell = 0;  // order cell: only surfaces of the same cell are ordered by distance
  std::int32_t low = 0;    // in plan: heights, in scene units
  std::int32_t high = 0;
  int depth = 0;  // cuts between the scene's face and this piece
};

// Squared largest distance between two points of the surface, the square of the paper's L.
[[nodiscard]] std::uint64_t squared_diameter(const std::vector<Point>& points);

}  // namespace sightline::algorithms::willis
