#include "host/algorithms/willis/boundary.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/algorithms/willis/distance.hpp"

namespace sightline::algorithms::willis {

namespace {

// The square of rho(v).
std::uint64_t squared_radius(const Surface& s, const Point& v) {
  std::uint64_t most = 0;
  for (const Point& w : s.points) most = std::max(most, squared_distance(v, w));
  return most;
}

bool normals_within_90(const Surface& s, const Surface& t) {
  return geometry::wide_dot(s.plane.normal, t.plane.normal) >= 0;
}

}  // namespace

bool can_obscure(const Surface& s, const Surface& t, bool rule90) {
  return std::any_of(t.points.begin(), t.points.end(), [&](const Point& p) { return s.plane.at(p) < 0; }) &&
         std::any_of(s.points.begin(), s.points.end(), [&](const Point& p) { return t.plane.at(p) > 0; }) &&
         (!rule90 || normals_within_90(s, t));
}

bool in_boundary(const Surface& s, const Point& p, BoundaryShape shape) {
  if (shape == BoundaryShape::oval) return within(p, s.points, s.plane.normal, squared_diameter(s.points));
  return std::any_of(s.points.begin(), s.points.end(),
                     [&](const Point& v) { return squared_distance(v, p) <= squared_radius(s, v); });
}

bool reaches(const Surface& t, const Surface& s, BoundaryShape shape) {
  if (shape == BoundaryShape::oval) return within(s, t, squared_diameter(s.points));
  return std::any_of(s.points.begin(), s.points.end(), [&](const Point& v) {
    return within(v, t.points, t.plane.normal, squared_radius(s, v));
  });
}

bool reach_each_other(const Surface& s, const Surface& t, BoundaryShape shape) {
  if (shape == BoundaryShape::oval)
    return within(s, t, std::max(squared_diameter(s.points), squared_diameter(t.points)));
  return reaches(t, s, shape) || reaches(s, t, shape);
}

bool form_cluster(const Surface& s, const Surface& t, const PairRules& rules) {
  return (can_obscure(s, t, rules.rule90) || can_obscure(t, s, rules.rule90)) &&
         reach_each_other(s, t, rules.shape);
}

double oval_area() {
  return std::numbers::pi + 2;
}

double two_circles_area() {
  return 4 * std::numbers::pi / 3 + std::sqrt(3.0) / 2;
}

double halves_ovals_area() {
  return 1 + std::numbers::pi / 4;
}

}  // namespace sightline::algorithms::willis
