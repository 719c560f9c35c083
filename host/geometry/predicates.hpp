// Signs of determinants of integer points: side of a plane, turn, crossing of segments.
//
// Limit: every |coordinate| is below 2^18 (predicate_coordinate_limit). Then the components of a difference are below
// 2^19, those of a cross product of two differences at most 2^39, and a determinant of three differences is below 2^60:
// all in int64. determinant(Vector...) takes three such cross products (normals) and is below 2^120: Int128. Nothing is
// rounded and there is no tolerance: zero means exactly on.
//
// Laws (tests/host/geometry/predicates_test.cpp tests them at random and at the limits):
//   alternating   swapping two arguments of cross, turn, orientation, normal_of or determinant changes the sign
//                 and nothing else; turn and orientation of points two of which are equal are 0
//   translation   if all points move by the same vector, functions of points do not change, except an offset
//   additive      turn(a, b, c) = turn(p, a, b) + turn(p, b, c) + turn(p, c, a) for every p; the same holds for
//                 orientation and the four faces of a tetrahedron
//   planes        plane_through(a, b, c) is 0 at a, b and c, and orientation(a, b, c, d) at d
//   flattened     turn(flattened a, b, c along an axis) is that component of normal_of(a, b, c)
//   segments      on_segment and segments_meet do not depend on the order of a segment's ends or of the
//                 segments; segments_meet(a, b, p, p) equals on_segment(a, b, p)
//   rings         doubled_area and locate_in_ring do not depend on where a ring starts; for the reversed ring
//                 the area changes its sign and the location does not. A point is on the ring iff it is on one
//                 of its sides.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "host/geometry/integer.hpp"

namespace sightline::geometry {

inline constexpr std::int32_t predicate_coordinate_limit = 1 << 18;

using Point3 = std::array<std::int32_t, 3>;
using Point2 = std::array<std::int32_t, 2>;
using Vector3 = std::array<std::int64_t, 3>;

// From b to a.
[[nodiscard]] constexpr Vector3 difference(const Point3& a, const Point3& b) {
  return {std::int64_t{a[0]} - b[0], std::int64_t{a[1]} - b[1], std::int64_t{a[2]} - b[2]};
}

[[nodiscard]] constexpr Vector3 vector_of(const Point3& p) {
  return {p[0], p[1], p[2]};
}

[[nodiscard]] constexpr Vector3 negated(const Vector3& v) {
  return {-v[0], -v[1], -v[2]};
}

[[nodiscard]] constexpr bool is_zero(const Vector3& v) {
  return v[0] == 0 && v[1] == 0 && v[2] == 0;
}

// Precondition: the components of the operands are below 2^31.
[[nodiscard]] constexpr Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// For a normal and a difference (2^39 by 2^19), or less.
[[nodiscard]] constexpr std::int64_t dot(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Precondition: the components of the vectors are below 2^62.
[[nodiscard]] constexpr Int128 wide_dot(const Vector3& a, const Vector3& b) {
  return Int128{a[0]} * b[0] + Int128{a[1]} * b[1] + Int128{a[2]} * b[2];
}

// a . (b x c) of three normals, components up to 2^40.
[[nodiscard]] constexpr Int128 determinant(const Vector3& a, const Vector3& b, const Vector3& c) {
  return a[0] * (Int128{b[1]} * c[2] - Int128{b[2]} * c[1]) +
         a[1] * (Int128{b[2]} * c[0] - Int128{b[0]} * c[2]) +
         a[2] * (Int128{b[0]} * c[1] - Int128{b[1]} * c[0]);
}

// (b - a) x (c - a): points to the side from which a, b, c turn counterclockwise; zero if they are collinear.
[[nodiscard]] constexpr Vector3 normal_of(const Point3& a, const Point3& b, const Point3& c) {
  return cross(difference(b, a), difference(c, a));
}

// Six times the volume of a, b, c, d: positive if d is on the side to which normal_of(a, b, c) points.
[[nodiscard]] constexpr std::int64_t orientation(const Point3& a, const Point3& b, const Point3& c,
                                                 const Point3& d) {
  return dot(normal_of(a, b, c), difference(d, a));
}

// The plane of the points p with normal . p = offset.
struct Plane {
  Vector3 normal{};
  std::int64_t offset = 0;

  // Positive on the side that the normal points to, 0 on the plane.
  [[nodiscard]] constexpr std::int64_t at(const Point3& p) const {
    return dot(normal, vector_of(p)) - offset;
  }
  [[nodiscard]] constexpr int side(const Point3& p) const { return sign(at(p)); }
  friend constexpr bool operator==(const Plane&, const Plane&) = default;
};

[[nodiscard]] constexpr Plane plane_through(const Point3& a, const Point3& b, const Point3& c) {
  const Vector3 normal = normal_of(a, b, c);
  return {normal, dot(normal, vector_of(a))};
}

// --- in a plane

// The best axis for projecting a plane with this normal: that of the largest component, the first among equals.
[[nodiscard]] constexpr std::size_t dominant_axis(const Vector3& normal) {
  std::size_t best = 0;
  for (std::size_t a = 1; a < 3; ++a) {
    const std::int64_t here = normal[a] < 0 ? -normal[a] : normal[a];
    const std::int64_t there = normal[best] < 0 ? -normal[best] : normal[best];
    if (here > there) best = a;
  }
  return best;
}

// The point without coordinate `axis`, the other two in cyclic order: a ring keeps its orientation as seen from the
// positive end of the axis.
[[nodiscard]] constexpr Point2 flattened(const Point3& p, std::size_t axis) {
  return {p[(axis + 1) % 3], p[(axis + 2) % 3]};
}

// Twice the area of a, b, c: positive if they turn counterclockwise.
[[nodiscard]] constexpr std::int64_t turn(const Point2& a, const Point2& b, const Point2& c) {
  return (std::int64_t{b[0]} - a[0]) * (std::int64_t{c[1]} - a[1]) -
         (std::int64_t{b[1]} - a[1]) * (std::int64_t{c[0]} - a[0]);
}

// Whether p is on the closed segment a, b (which may be a point).
[[nodiscard]] constexpr bool on_segment(const Point2& a, const Point2& b, const Point2& p) {
  const auto between = [](std::int32_t m, std::int32_t n, std::int32_t c) {
    return m < n ? m <= c && c <= n : n <= c && c <= m;
  };
  return turn(a, b, p) == 0 && between(a[0], b[0], p[0]) && between(a[1], b[1], p[1]);
}

// Whether the closed segments have a point in common.
[[nodiscard]] constexpr bool segments_meet(const Point2& a, const Point2& b, const Point2& c,
                                           const Point2& d) {
  const int c_side = sign(turn(a, b, c));
  const int d_side = sign(turn(a, b, d));
  const int a_side = sign(turn(c, d, a));
  const int b_side = sign(turn(c, d, b));
  if (c_side * d_side < 0 && a_side * b_side < 0) return true;
  return on_segment(a, b, c) || on_segment(a, b, d) || on_segment(c, d, a) || on_segment(c, d, b);
}

// Twice the area of a ring, positive if it is counterclockwise. At most 2^23 points.
[[nodiscard]] constexpr std::int64_t doubled_area(std::span<const Point2> ring) {
  std::int64_t area = 0;
  for (std::size_t i = 2; i < ring.size(); ++i) area += turn(ring[0], ring[i - 1], ring[i]);
  return area;
}

// -1 outside, 0 on, 1 inside a ring that does not cross itself.
[[nodiscard]] constexpr int locate_in_ring(std::span<const Point2> ring, const Point2& p) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2& a = ring[i];
    const Point2& b = ring[i + 1 == ring.size() ? 0 : i + 1];
    if (on_segment(a, b, p)) return 0;
    if ((a[1] > p[1]) != (b[1] > p[1]) && (turn(a, b, p) > 0) == (b[1] > a[1])) inside = !inside;
  }
  return inside ? 1 : -1;
}

}  // namespace sightline::geometry
