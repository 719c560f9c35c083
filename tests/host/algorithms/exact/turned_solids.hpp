// Prisms turned by any angle and read as a single-precision mesh, as files of parts are.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "host/scene/read/poly_import.hpp"
#include "tests/support/dice.hpp"

namespace sightline::algorithms::turned_solids {

using Point = std::array<double, 3>;
using Matrix = std::array<Point, 3>;
using Dice = programs::jones::Dice;

inline double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Point unit(const Point& a) {
  const double length = std::sqrt(dot(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}
inline Point rotate(const Matrix& m, const Point& p) {
  return {dot(m[0], p), dot(m[1], p), dot(m[2], p)};
}

inline Point random_direction(Dice& dice) {
  while (true) {
    const Point p{dice(-1000, 1000) / 1000.0, dice(-1000, 1000) / 1000.0, dice(-1000, 1000) / 1000.0};
    if (dot(p, p) > 0.01 && dot(p, p) < 1) return unit(p);
  }
}

inline Matrix random_turn(Dice& dice) {
  const Point a = random_direction(dice);
  while (true) {
    const Point b = random_direction(dice);
    if (std::abs(dot(a, b)) > 0.9) continue;
    const Point c = unit(cross(a, b));
    return {a, c, cross(a, c)};
  }
}

struct Solid {
  std::vector<Point> vertices;
  std::vector<std::vector<scene::VertexIndex>> faces;
};

// A prism over a polygon around the origin, its sides divided into triangles: the bends between the sides are those of the
// polygon,
// and the diagonals are flat.
inline void add_prism(Solid& solid, Dice& dice, const Point& at, int most_sides = 9) {
  const int sides = dice(3, most_sides);
  const auto first = static_cast<scene::VertexIndex>(solid.vertices.size());
  const double height = dice(20, 60) / 10.0;
  std::vector<double> angles;
  for (int i = 0; i < sides; ++i) angles.push_back((i + dice(-30, 30) / 100.0) * 2 * std::numbers::pi / sides);
  for (int level = 0; level < 2; ++level)
    for (const double angle : angles)
      solid.vertices.push_back({at[0] + 3 * std::cos(angle), at[1] + 3 * std::sin(angle), at[2] + level * height});
  const auto n = static_cast<scene::VertexIndex>(sides);
  for (scene::VertexIndex i = 0; i < n; ++i) {
    const scene::VertexIndex j = (i + 1) % n;
    solid.faces.push_back({first + i, first + j, first + n + j});
    solid.faces.push_back({first + i, first + n + j, first + n + i});
  }
  for (scene::VertexIndex i = 1; i + 1 < n; ++i) {
    solid.faces.push_back({first, first + i + 1, first + i});
    solid.faces.push_back({first + n, first + n + i, first + n + i + 1});
  }
}

inline scene::PolyScene scene_of(const Solid& solid, const Matrix& turn, const Point& shift) {
  scene::PolyMesh mesh;
  mesh.bodies.emplace_back();
  for (const auto& face : solid.faces) mesh.bodies[0].faces.push_back({face, {}});
  for (const Point& p : solid.vertices) {
    Point q = rotate(turn, p);
    for (std::size_t a = 0; a < 3; ++a) q[a] = static_cast<float>(q[a] + shift[a]);
    mesh.vertices.push_back(q);
  }
  mesh.precision = 0x1p-19;  // float32 from 16 to 32
  auto import = scene::import_poly(std::move(mesh), {.mend = true});
  EXPECT_TRUE(import);
  if (!import) return {};
  EXPECT_EQ(import->report.faces.merged_vertices + import->report.faces.dropped_faces, 0U);
  return std::move(import->scene);
}

}  // namespace sightline::algorithms::turned_solids
