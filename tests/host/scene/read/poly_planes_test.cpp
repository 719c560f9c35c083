// Surfaces: flat surfaces stay whole when they are turned and rounded, round surfaces stay divided.
#include "host/scene/read/poly_planes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "host/scene/read/poly_import.hpp"

namespace sightline::scene {
namespace {

using Point = std::array<double, 3>;

// A turn by an odd angle, so that no coordinate stays an integer.
Point rotate(const Point& p, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const Point q{c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]};
  return {q[0], c * q[1] - s * q[2], s * q[1] + c * q[2]};
}

// A plate with n x n squares on each large side, all of two triangles, in float32 precision.
PolyMesh plate(int n, double angle) {
  PolyMesh mesh;
  mesh.bodies.emplace_back();
  auto& faces = mesh.bodies[0].faces;
  const auto at = [n](int i, int j, int side) { return static_cast<VertexIndex>((side * (n + 1) + j) * (n + 1) + i); };
  for (int side = 0; side < 2; ++side)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) {
        Point p = rotate({i * 10.0 / n, j * 10.0 / n, 1.5 * side}, angle);
        for (double& c : p) c = static_cast<float>(c);
        mesh.vertices.push_back(p);
      }
  const auto square = [&](VertexIndex a, VertexIndex b, VertexIndex c, VertexIndex d) {
    faces.push_back({{a, b, c}, {}});
    faces.push_back({{a, c, d}, {}});
  };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      square(at(i, j, 0), at(i, j + 1, 0), at(i + 1, j + 1, 0), at(i + 1, j, 0));
      square(at(i, j, 1), at(i + 1, j, 1), at(i + 1, j + 1, 1), at(i, j + 1, 1));
    }
  for (int i = 0; i < n; ++i) {
    square(at(i, 0, 0), at(i + 1, 0, 0), at(i + 1, 0, 1), at(i, 0, 1));
    square(at(i + 1, n, 0), at(i, n, 0), at(i, n, 1), at(i + 1, n, 1));
    square(at(0, i + 1, 0), at(0, i, 0), at(0, i, 1), at(0, i + 1, 1));
    square(at(n, i, 0), at(n, i + 1, 0), at(n, i + 1, 1), at(n, i, 1));
  }
  mesh.precision = 0x1p-20;  // of float32 from 8 to 16
  return mesh;
}

TEST(PolyPlanes, ATurnedPlateHasSixSurfaces) {
  for (int k = 0; k < 20; ++k) {
    const auto import = import_poly(plate(12, 0.1 + 0.07 * k), {.mend = true});
    ASSERT_TRUE(import);
    EXPECT_EQ(import->scene.surfaces.size(), 6U) << k;
    EXPECT_EQ(import->scene.surface_of.size(), 2U * (2 * 144 + 4 * 12));
    for (const PolySurface& surface : import->scene.surfaces) {
      const auto& n = surface.normal;
      EXPECT_NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, 1e-12);
    }
  }
}

// A box of size 1 with bevels of 0.2 at 45 degrees, in tenths: its numbers have as few digits as its bevels are small, and are
// exact.
TEST(PolyPlanes, BevelsOfFewDecimalsAreNotErrors) {
  PolyMesh mesh;
  for (const double y : {0.0, 0.8}) mesh.vertices.insert(mesh.vertices.end(), {{0, y, 0}, {1, y, 0}, {1, y, 1}, {0, y, 1}});
  mesh.vertices.insert(mesh.vertices.end(), {{0.2, 1, 0.2}, {0.8, 1, 0.2}, {0.8, 1, 0.8}, {0.2, 1, 0.8}});
  mesh.bodies.emplace_back();
  for (const VertexIndex ring : {0U, 4U})
    for (VertexIndex i = 0; i < 4; ++i)
      mesh.bodies[0].faces.push_back({{ring + i, ring + 4 + i, ring + 4 + (i + 1) % 4, ring + (i + 1) % 4}, {}});
  mesh.bodies[0].faces.push_back({{0, 1, 2, 3}, {}});
  mesh.bodies[0].faces.push_back({{11, 10, 9, 8}, {}});
  mesh.precision = 0.1;
  const auto import = import_poly(mesh, {.mend = true});
  ASSERT_TRUE(import);
  EXPECT_EQ(import->scene.surfaces.size(), 10U);
}

// Each pair of neighbours is within the tolerance; no two may be joined because of that.
TEST(PolyPlanes, ACylinderOfManySidesStaysRound) {
  constexpr int sides = 2000;
  PolyMesh mesh;
  mesh.bodies.emplace_back();
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    mesh.vertices.push_back({std::cos(angle), std::sin(angle), 0});
    mesh.vertices.push_back({std::cos(angle), std::sin(angle), 1});
  }
  for (VertexIndex i = 0; i < sides; ++i) {
    const VertexIndex j = (i + 1) % sides;
    mesh.bodies[0].faces.push_back({{2 * i, 2 * j, 2 * j + 1, 2 * i + 1}, {}});
  }
  // A strip k sides wide leaves the plane of its first one by about k^2 times this.
  const double sagitta = 1 - std::cos(std::numbers::pi / sides);
  mesh.precision = 4 * sagitta;  // the tolerance is 16 of them: at most a few sides in each direction
  const auto import = import_poly(std::move(mesh), {.mend = true});
  ASSERT_TRUE(import);
  EXPECT_GT(import->scene.surfaces.size(), static_cast<std::size_t>(sides / 12));
  EXPECT_LT(import->scene.surfaces.size(), static_cast<std::size_t>(sides / 2));
}

TEST(PolyPlanes, ToleranceZeroKeepsFacesApartThatBendAtAll) {
  const auto import = import_poly(plate(3, 0.4), {.mend = true, .planar_tolerance = 0.0});
  ASSERT_TRUE(import);
  EXPECT_GT(import->scene.surfaces.size(), 6U);
}

}  // namespace
}  // namespace sightline::scene
