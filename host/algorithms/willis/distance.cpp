// The same formulas twice: distances in double, and comparisons with the limit in integers, where both sides are
// multiplied by the divisor instead of dividing.
#include "host/algorithms/willis/distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "host/geometry/wide_integer.hpp"

namespace sightline::algorithms::willis {

namespace {

using geometry::WideInteger;

// Coordinates are below 2^30, normals below 2^40 (surface.hpp).
using Difference = WideInteger<31>;
using NormalPart = WideInteger<40>;
using Limit = WideInteger<64>;

template <class Number>
using Vector = std::array<Number, 3>;

Vector<double> approximate(const Vector3& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}
Vector<double> approximate_difference(const Point& a, const Point& b) {
  return approximate(between(a, b));
}
Vector<Difference> exact_difference(const Point& a, const Point& b) {
  const Vector3 v = between(a, b);
  return {Difference(v[0]), Difference(v[1]), Difference(v[2])};
}

template <class A, class B>
auto dot(const Vector<A>& a, const Vector<B>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class A, class B>
auto cross(const Vector<A>& a, const Vector<B>& b) {
  using Number = decltype(a[1] * b[2] - a[2] * b[1]);
  return Vector<Number>{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Squared distance of p from the segment a, b. If rounding confuses an end with the foot of the perpendicular, the two
// distances hardly differ; the same holds for polygons below.
double to_segment(const Point& p, const Point& a, const Point& b) {
  const auto along = approximate_difference(b, a);
  const auto away = approximate_difference(p, a);
  const double foot = dot(away, along);
  const double length = dot(along, along);
  if (foot <= 0) return dot(away, away);
  if (foot >= length) {
    const auto beyond = approximate_difference(p, b);
    return dot(beyond, beyond);
  }
  return dot(away, away) - foot * foot / length;
}

bool segment_within_exactly(const Point& p, const Point& a, const Point& b, const Limit& limit) {
  const auto along = exact_difference(b, a);
  const auto away = exact_difference(p, a);
  const auto foot = dot(away, along);
  const auto length = dot(along, along);
  if (foot.sign() <= 0) return dot(away, away) <= limit;
  if (foot >= length) {
    const auto beyond = exact_difference(p, b);
    return dot(beyond, beyond) <= limit;
  }
  return dot(away, away) * length - foot * foot <= limit * length;
}

double to_polygon(const Point& p, const std::vector<Point>& polygon, const Vector3& plane_normal) {
  if (polygon.size() == 2) return to_segment(p, polygon[0], polygon[1]);
  const auto normal = approximate(plane_normal);
  bool inside = true;
  for (std::size_t i = 0; inside && i < polygon.size(); ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    inside = dot(cross(normal, approximate_difference(b, a)), approximate_difference(p, a)) >= 0;
  }
  if (inside) {
    const double height = dot(normal, approximate_difference(p, polygon[0]));
    return height * height / dot(normal, normal);
  }
  double least = to_segment(p, polygon.back(), polygon.front());
  for (std::size_t i = 1; i < polygon.size(); ++i)
    least = std::min(least, to_segment(p, polygon[i - 1], polygon[i]));
  return least;
}

bool polygon_within_exactly(const Point& p, const std::vector<Point>& polygon, const Vector3& plane_normal,
                            const Limit& limit) {
  if (polygon.size() == 2) return segment_within_exactly(p, polygon[0], polygon[1], limit);
  const Vector<NormalPart> normal{NormalPart(plane_normal[0]), NormalPart(plane_normal[1]),
                                  NormalPart(plane_normal[2])};
  bool inside = true;
  for (std::size_t i = 0; inside && i < polygon.size(); ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    inside = dot(cross(normal, exact_difference(b, a)), exact_difference(p, a)).sign() >= 0;
  }
  if (inside) {
    const auto height = dot(normal, exact_difference(p, polygon[0]));
    return height * height <= limit * dot(normal, normal);
  }
  bool within = segment_within_exactly(p, polygon.back(), polygon.front(), limit);
  for (std::size_t i = 1; !within && i < polygon.size(); ++i)
    within = segment_within_exactly(p, polygon[i - 1], polygon[i], limit);
  return within;
}

// A bound of the rounding error relative to the squared lengths that were used: the formulas take about twenty roundings
// with an error of up to 2^-53 each.
constexpr double rounding = 64 * 0x1p-53;
// For lines that are not too nearly parallel (flat_angle), the normal loses half of its digits.
constexpr double crossing_rounding = 1e-8;
constexpr double flat_angle = 1e-8;  // squared sine

double reach(const Point& p, const std::vector<Point>& polygon) {
  double most = 0;
  for (const Point& q : polygon) most = std::max(most, static_cast<double>(squared_distance(p, q)));
  // No edge is longer than two of these.
  return 4 * most;
}

// Yes, no, or nullopt if it is too close to decide.
std::optional<bool> decide(double distance, double uncertain, std::uint64_t limit) {
  const auto bound = static_cast<double>(limit);
  uncertain += bound * 0x1p-52;
  if (distance + uncertain < bound) return true;
  if (distance - uncertain > bound) return false;
  return std::nullopt;
}

Limit exact(std::uint64_t limit) {
  return Limit(Int128{limit});
}

// nullopt if the common perpendicular of the lines does not meet both segments; `unsure` is set if the lines are too
// nearly parallel to decide.
std::optional<double> across(const Point& a, const Point& b, const Point& c, const Point& d, bool& unsure) {
  const auto e = approximate_difference(b, a);
  const auto f = approximate_difference(d, c);
  const auto w = approximate_difference(c, a);
  const auto n = cross(e, f);
  const double square = dot(n, n);
  if (square == 0) return std::nullopt;
  unsure = square < flat_angle * dot(e, e) * dot(f, f);
  const double s = dot(cross(w, f), n);
  const double t = dot(cross(w, e), n);
  if (s < 0 || s > square || t < 0 || t > square) return std::nullopt;
  const double height = dot(w, n);
  return height * height / square;
}

bool edges_within_exactly(const Point& a, const Point& b, const Point& c, const Point& d,
                          const Limit& limit) {
  const auto e = exact_difference(b, a);
  const auto f = exact_difference(d, c);
  const auto w = exact_difference(c, a);
  const auto n = cross(e, f);
  const auto square = dot(n, n);
  if (square.sign() == 0) return false;
  const auto s = dot(cross(w, f), n);
  const auto t = dot(cross(w, e), n);
  if (s.negative() || s > square || t.negative() || t > square) return false;
  const auto height = dot(w, n);
  return height * height <= limit * square;
}

// Tests only the common perpendicular; if the nearest point is an end, the test of corners finds it.
bool edges_within(const Point& a, const Point& b, const Point& c, const Point& d, std::uint64_t limit) {
  bool unsure = false;
  const auto distance = across(a, b, c, d, unsure);
  if (unsure) return edges_within_exactly(a, b, c, d, exact(limit));
  if (!distance) return false;
  const double size = static_cast<double>(squared_distance(a, c)) +
                      static_cast<double>(squared_distance(a, b)) +
                      static_cast<double>(squared_distance(c, d));
  const auto answer = decide(*distance, size * crossing_rounding, limit);
  return answer ? *answer : edges_within_exactly(a, b, c, d, exact(limit));
}

template <class PointTest, class EdgeTest>
bool any_within(const Surface& s, const Surface& t, PointTest&& point_within, EdgeTest&& edge_within) {
  for (const Point& p : s.points)
    if (point_within(p, t)) return true;
  for (const Point& p : t.points)
    if (point_within(p, s)) return true;
  for (std::size_t i = 0; i < s.points.size(); ++i) {
    for (std::size_t j = 0; j < t.points.size(); ++j) {
      if (edge_within(s.points[i], s.points[(i + 1) % s.points.size()], t.points[j],
                      t.points[(j + 1) % t.points.size()]))
        return true;
    }
  }
  return false;
}

// Six times the volume of the tetrahedron a, b, c, d: below 2^101.
int orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Vector3 u = between(b, a);
  const Vector3 v = between(c, a);
  const Vector3 w = between(d, a);
  const auto minor = [](std::int64_t p, std::int64_t q, std::int64_t r, std::int64_t s) {
    return Int128{p} * s - Int128{q} * r;
  };
  return geometry::sign(minor(u[1], u[2], v[1], v[2]) * w[0] + minor(u[2], u[0], v[2], v[0]) * w[1] +
                        minor(u[0], u[1], v[0], v[1]) * w[2]);
}

// For points in one plane, as seen from the end of its normal.
int turn(const Vector3& normal, const Point& a, const Point& b, const Point& c) {
  const std::size_t axis = geometry::dominant_axis(normal);
  const Vector3 u = between(b, a);
  const Vector3 v = between(c, a);
  const std::size_t x = (axis + 1) % 3;
  const std::size_t y = (axis + 2) % 3;
  const int sign = geometry::sign(Int128{u[x]} * v[y] - Int128{u[y]} * v[x]);
  return normal[axis] < 0 ? -sign : sign;
}

// Whether the segment p, q, which is in the plane of the polygon, has a point in common with it.
bool flat_segment_meets(const Point& p, const Point& q, const Surface& t) {
  // They do not meet iff a side of the polygon, or the segment's line, separates them.
  int left = 0;
  int right = 0;
  for (const Point& c : t.points) {
    const int side = turn(t.plane.normal, p, q, c);
    left += side > 0;
    right += side < 0;
  }
  const auto count = static_cast<int>(t.points.size());
  if (left == count || right == count) return false;
  for (std::size_t i = 0; i < t.points.size(); ++i) {
    const Point& a = t.points[i];
    const Point& b = t.points[(i + 1) % t.points.size()];
    if (turn(t.plane.normal, a, b, p) < 0 && turn(t.plane.normal, a, b, q) < 0) return false;
  }
  return true;
}

// In plan all points are in one level plane; collinear segments meet if their boxes do.
bool segments_meet(const Surface& s, const Surface& t) {
  const int a = t.plane.side(s.points[0]);
  const int b = t.plane.side(s.points[1]);
  const int c = s.plane.side(t.points[0]);
  const int d = s.plane.side(t.points[1]);
  if (a * b > 0 || c * d > 0) return false;
  return true;
}

bool boxes_apart(const Surface& s, const Surface& t) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto lower = [axis](const Point& a, const Point& b) { return a[axis] < b[axis]; };
    const auto [s_low, s_high] = std::minmax_element(s.points.begin(), s.points.end(), lower);
    const auto [t_low, t_high] = std::minmax_element(t.points.begin(), t.points.end(), lower);
    if ((*s_high)[axis] < (*t_low)[axis] || (*t_high)[axis] < (*s_low)[axis]) return true;
  }
  return false;
}

bool edge_meets(const Point& p, const Point& q, const Surface& t) {
  const int a = t.plane.side(p);
  const int b = t.plane.side(q);
  if (a * b > 0) return false;
  if (a == 0 && b == 0) return flat_segment_meets(p, q, t);
  int left = 0;
  int right = 0;
  for (std::size_t i = 0; i < t.points.size(); ++i) {
    const int side = orientation(p, q, t.points[i], t.points[(i + 1) % t.points.size()]);
    left += side > 0;
    right += side < 0;
  }
  return left == 0 || right == 0;
}

}  // namespace

std::uint64_t squared_diameter(const std::vector<Point>& points) {
  std::uint64_t most = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) most = std::max(most, squared_distance(points[i], points[j]));
  return most;
}

bool within_exactly(const Point& p, const std::vector<Point>& polygon, const Vector3& normal,
                    std::uint64_t limit) {
  return polygon_within_exactly(p, polygon, normal, exact(limit));
}

bool within(const Point& p, const std::vector<Point>& polygon, const Vector3& normal, std::uint64_t limit) {
  const auto answer = decide(to_polygon(p, polygon, normal), reach(p, polygon) * rounding, limit);
  return answer ? *answer : within_exactly(p, polygon, normal, limit);
}

bool within(const Surface& s, const Surface& t, std::uint64_t limit) {
  return any_within(
      s, t, [limit](const Point& p, const Surface& u) { return within(p, u.points, u.plane.normal, limit); },
      [limit](const Point& a, const Point& b, const Point& c, const Point& d) {
        return edges_within(a, b, c, d, limit);
      });
}

bool within_exactly(const Surface& s, const Surface& t, std::uint64_t limit) {
  return any_within(
      s, t,
      [limit](const Point& p, const Surface& u) {
        return within_exactly(p, u.points, u.plane.normal, limit);
      },
      [limit](const Point& a, const Point& b, const Point& c, const Point& d) {
        return edges_within_exactly(a, b, c, d, exact(limit));
      });
}

bool meet(const Surface& s, const Surface& t) {
  if (boxes_apart(s, t)) return false;
  if (s.points.size() == 2) return segments_meet(s, t);
  for (std::size_t i = 0; i < s.points.size(); ++i)
    if (edge_meets(s.points[i], s.points[(i + 1) % s.points.size()], t)) return true;
  for (std::size_t i = 0; i < t.points.size(); ++i)
    if (edge_meets(t.points[i], t.points[(i + 1) % t.points.size()], s)) return true;
  return false;
}

}  // namespace sightline::algorithms::willis
