// Boundaries, distances and cuts: areas by sampling, and the filter compared with numbers of any length. hard_cases_test.cpp has
// pair
// tests and the paper's figures.
#include "host/algorithms/willis/boundary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "host/algorithms/willis/cut.hpp"
#include "host/algorithms/willis/distance.hpp"
#include "tests/host/algorithms/willis/walls.hpp"

namespace sightline::algorithms::willis {
namespace {

TEST(WillisBoundary, FaceToFaceNeitherHidesTheOther) {
  const Surface t = wall({0, 10}, {5, 10}, 1);  // seen from below
  EXPECT_FALSE(form_cluster(flip(wall({0, 0}, {10, 0})), t, {}));
  EXPECT_TRUE(form_cluster(wall({0, 0}, {10, 0}), t, {}));  // facing the same way
}

TEST(WillisBoundary, AreasBySampling) {
  constexpr std::int32_t length = 1000;
  const Surface s = wall({0, 0}, {length, 0});
  const Surface left = wall({0, 0}, {length / 2, 0});
  const Surface right = wall({length / 2, 0}, {length, 0});
  std::mt19937 random(7);
  constexpr int samples = 200'000;
  int oval = 0;
  int circles = 0;
  int halves = 0;
  // A square of 3 L by 3 L around the wall.
  for (int i = 0; i < samples; ++i) {
    const auto place = [&](std::int32_t from) {
      return from * lattice_unit + static_cast<std::int32_t>(random() % (3U * length * lattice_unit));
    };
    const Point p{place(-length), 0, place(-3 * length / 2)};
    oval += in_boundary(s, p, BoundaryShape::oval);
    circles += in_boundary(s, p, BoundaryShape::ball);
    halves += in_boundary(left, p, BoundaryShape::oval) || in_boundary(right, p, BoundaryShape::oval);
    EXPECT_TRUE(!in_boundary(s, p, BoundaryShape::ball) || in_boundary(s, p, BoundaryShape::oval));
  }
  // Five standard deviations of a count of this size.
  const auto expect = [&](int count, double area) {
    const double share = area / 9;
    EXPECT_NEAR(count, share * samples, 5 * std::sqrt(share * (1 - share) * samples)) << area;
  };
  expect(oval, oval_area());
  expect(circles, two_circles_area());
  expect(halves, halves_ovals_area());
}

// Normals of (-0.98, -0.17) and (0.98, -0.17), seen along +z: both are visible, one hides the other.
TEST(WillisBoundary, OcclusionWithNormalsFarBeyond90Degrees) {
  const Surface near = wall({17, 0}, {0, 98});
  ASSERT_EQ(near.plane.normal, (Vector3{98, 0, 17}));
  const Surface s = flip(near);                  // (-98, -17)
  const Surface t = wall({0, 200}, {17, 298}, 1);  // (98, -17)
  EXPECT_TRUE(can_obscure(s, t));
  EXPECT_FALSE(can_obscure(s, t, true));
}

// The same results with and without the filter, mostly at and next to equality.
TEST(WillisDistance, FilterAgainstLongNumbers) {
  std::mt19937 random(3);
  const auto coordinate = [&](std::int32_t size) {
    return static_cast<std::int32_t>(random() % static_cast<std::uint32_t>(2 * size)) - size;
  };
  int equal = 0;
  for (int i = 0; i < 3000; ++i) {
    const std::int32_t size = i % 3 == 0 ? 4 : i % 3 == 1 ? 3000 : (1 << 29);
    const auto triangle = [&] {
      Surface s;
      for (int k = 0; k < 3; ++k) s.points.push_back({coordinate(size), coordinate(size), coordinate(size)});
      // Any vector perpendicular to the triangle will do; a short one, as in the planes of scenes.
      const Vector3 u = between(s.points[1], s.points[0]);
      const Vector3 v = between(s.points[2], s.points[0]);
      if (size < 4000) s.plane.normal = geometry::cross(u, v);
      return s;
    };
    const Surface s = triangle();
    const Surface t = triangle();
    if (size > 4000 || geometry::is_zero(s.plane.normal) || geometry::is_zero(t.plane.normal)) continue;
    const std::uint64_t limit = squared_distance(s.points[0], t.points[0]);
    for (const std::uint64_t l : {limit, limit - (limit > 0), limit / 2, limit + 1}) {
      EXPECT_EQ(within(s.points[0], t.points, t.plane.normal, l),
                within_exactly(s.points[0], t.points, t.plane.normal, l));
      EXPECT_EQ(within(s, t, l), within_exactly(s, t, l));
    }
    equal += within_exactly(s, t, limit) != within_exactly(s, t, limit - (limit > 0));
  }
  EXPECT_GT(equal, 10);  // equality occurs
}

TEST(WillisCut, PiecesTileTheSurfaceAndItsDiameterFalls) {
  std::mt19937 random(11);
  for (int i = 0; i < 200; ++i) {
    // A parallelogram in the plane x + y + z = 0, given by two integer edges.
    const auto edge = [&] {
      const auto a = static_cast<std::int32_t>(random() % 2000) - 1000;
      const auto b = static_cast<std::int32_t>(random() % 2000) - 1000;
      return std::array{a, b, -a - b};
    };
    const auto u = edge();
    const auto v = edge();
    Surface s;
    s.plane.normal = {1, 1, 1};
    const auto at = [&](std::int32_t m, std::int32_t n) {
      return on_lattice({m * u[0] + n * v[0], m * u[1] + n * v[1], m * u[2] + n * v[2]});
    };
    s.points = {at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
    const auto area = [](const Surface& piece) {
      std::int64_t sum = 0;
      for (std::size_t k = 2; k < piece.points.size(); ++k) {
        sum += geometry::cross(between(piece.points[k - 1], piece.points[0]),
                               between(piece.points[k], piece.points[0]))[0];
      }
      return sum;
    };
    if (area(s) == 0) continue;
    const auto halves = halve(s);
    ASSERT_TRUE(halves);
    EXPECT_EQ(area((*halves)[0]) + area((*halves)[1]), area(s));
    for (const Surface& half : *halves) {
      EXPECT_GT(area(half) * (area(s) > 0 ? 1 : -1), 0);
      EXPECT_LE(squared_diameter(half.points), squared_diameter(s.points));
      for (const Point& p : half.points) EXPECT_EQ(half.plane.side(p), 0);
    }
  }
}

TEST(WillisCut, TwelveHalvingsThenTheLattice) {
  Surface s = wall({0, 0}, {1, 0});
  for (int i = 0; i < lattice_bits; ++i) {
    const auto halves = halve(s);
    ASSERT_TRUE(halves) << i;
    s = (*halves)[1];
  }
  EXPECT_EQ(squared_diameter(s.points), 1U);
  EXPECT_FALSE(halve(s));
}

TEST(WillisCut, AMiddleBesideTheLatticeIsMovedAlongTheEdge) {
  Surface s = wall({0, 0}, {3, 6}, 0);
  for (int i = 0; i < lattice_bits + 1; ++i) {
    const auto halves = halve(s);
    ASSERT_TRUE(halves) << i;
    s = (*halves)[squared_diameter((*halves)[1].points) > squared_diameter((*halves)[0].points) ? 1 : 0];
    for (const Point& p : s.points) EXPECT_EQ(s.plane.side(p), 0);
  }
  EXPECT_LE(squared_diameter(s.points), 4U * 5U);
}

TEST(WillisCut, ByAPlaneOnlyAtLatticePoints) {
  const Surface s = wall({0, 0}, {10, 5});
  const auto upright = [](std::int64_t x) { return SurfacePlane{{1, 0, 0}, x}; };
  const auto pieces = cut_by(s, upright(4));
  ASSERT_TRUE(pieces);
  EXPECT_EQ((*pieces)[0].points[0], on_lattice({4, 0, 2}));
  EXPECT_FALSE(cut_by(s, SurfacePlane{{3, 0, 0}, 10}));
}

}  // namespace
}  // namespace sightline::algorithms::willis
