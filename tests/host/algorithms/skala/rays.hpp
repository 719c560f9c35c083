// Rays through triangles in floating point, for tests that share no code with the programs.
#pragma once

#include <array>
#include <cmath>

namespace sightline::test {

using Point = std::array<double, 3>;

inline Point operator-(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Point between(const Point& a, const Point& b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

// Whether the ray meets the triangle farther away than `least` times its direction.
inline bool meets(const Point& from, const Point& direction, const std::array<Point, 3>& triangle, double least) {
  const Point u = triangle[1] - triangle[0];
  const Point v = triangle[2] - triangle[0];
  const Point n = cross(direction, v);
  const double d = dot(u, n);
  if (std::abs(d) < 1e-14) return false;
  const Point w = from - triangle[0];
  const double b = dot(w, n) / d;
  const Point m = cross(w, u);
  const double c = dot(direction, m) / d;
  return b >= 0 && c >= 0 && b + c <= 1 && dot(v, m) / d > least;
}

}  // namespace sightline::test
