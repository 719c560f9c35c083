// The laws of predicates.hpp for random points, at the limits, and for worked examples.
#include "host/geometry/predicates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace sightline::geometry {
namespace {

constexpr std::int32_t most = predicate_coordinate_limit - 1;

class RandomPoints {
 public:
  explicit RandomPoints(std::int32_t reach) : reach_(reach) {}
  Point3 next() { return {coordinate(), coordinate(), coordinate()}; }

 private:
  std::int32_t coordinate() {
    return static_cast<std::int32_t>(engine_() % static_cast<unsigned>(2 * reach_ + 1)) - reach_;
  }
  std::mt19937 engine_{1971};
  std::int32_t reach_;
};

TEST(Predicates, OrientationIsAlternating) {
  for (const std::int32_t reach : {1, 3, 1000, most}) {
    RandomPoints points(reach);
    for (int i = 0; i < 500; ++i) {
      const Point3 a = points.next(), b = points.next(), c = points.next(), d = points.next();
      const std::int64_t volume = orientation(a, b, c, d);
      EXPECT_EQ(orientation(b, a, c, d), -volume);
      EXPECT_EQ(orientation(a, c, b, d), -volume);
      EXPECT_EQ(orientation(a, b, d, c), -volume);
      EXPECT_EQ(orientation(c, a, b, d), volume);
      EXPECT_EQ(normal_of(b, c, a), normal_of(a, b, c));
      EXPECT_EQ(normal_of(b, a, c), negated(normal_of(a, b, c)));
    }
  }
}

TEST(Predicates, APlaneGoesThroughItsPointsAndAgreesWithOrientation) {
  RandomPoints points(most);
  for (int i = 0; i < 500; ++i) {
    const Point3 a = points.next(), b = points.next(), c = points.next(), d = points.next();
    const Plane plane = plane_through(a, b, c);
    EXPECT_EQ(plane.side(a), 0);
    EXPECT_EQ(plane.side(b), 0);
    EXPECT_EQ(plane.side(c), 0);
    EXPECT_EQ(plane.at(d), orientation(a, b, c, d));
  }
}

TEST(Predicates, TheLimitsOfTheHeaderHoldAtTheCornersOfSpace) {
  // A tetrahedron in the corners of the cube has a third of its volume: 6 V = 2 side^3.
  constexpr std::int64_t side = 2 * std::int64_t{most};
  constexpr std::int64_t volume =
      orientation({-most, -most, -most}, {most, most, -most}, {-most, most, most}, {most, -most, most});
  static_assert(volume == 2 * side * side * side || volume == -2 * side * side * side);
  static_assert((volume < 0 ? -volume : volume) < (std::int64_t{1} << 60));
  constexpr std::int64_t n = 2 * side * side;  // the largest possible component
  static_assert(n < (std::int64_t{1} << 39));
  constexpr Int128 det = determinant({n, n, -n}, {n, -n, n}, {-n, n, n});
  static_assert(det == Int128{-4} * n * n * n);
}

TEST(Predicates, DeterminantIsTheTripleProduct) {
  RandomPoints points(most);
  for (int i = 0; i < 500; ++i) {
    const Vector3 a = vector_of(points.next()), b = vector_of(points.next()), c = vector_of(points.next());
    EXPECT_TRUE(determinant(a, b, c) == dot(a, cross(b, c)));
    EXPECT_TRUE(determinant(b, a, c) == -dot(a, cross(b, c)));
    EXPECT_TRUE(determinant(a, b, a) == 0);
    EXPECT_TRUE(wide_dot(a, b) == dot(a, b));
  }
}

TEST(Predicates, OneUnitInTheLastPlaceDecides) {
  // Nearly parallel over the full range: doubles would round both products to the same number.
  EXPECT_EQ(turn({-most, -most}, {most, most}, {most - 1, most}), 2 * std::int64_t{most});
  EXPECT_EQ(turn({0, 0}, {most, most - 1}, {most - 1, most - 2}), -1);
  EXPECT_EQ(orientation({0, 0, 0}, {1, 0, 0}, {0, most, most - 1}, {most, most - 1, most - 2}), -1);
}

TEST(Predicates, FlatteningKeepsTheTurn) {
  RandomPoints points(50);
  for (int i = 0; i < 500; ++i) {
    const Point3 a = points.next(), b = points.next(), c = points.next();
    const Vector3 normal = normal_of(a, b, c);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(turn(flattened(a, axis), flattened(b, axis), flattened(c, axis)), normal[axis]);
    }
    const std::size_t best = dominant_axis(normal);
    if (!is_zero(normal)) {
      EXPECT_NE(normal[best], 0);
    }
  }
}

TEST(Predicates, SegmentsMeetAlsoInAPointOrOnALine) {
  EXPECT_TRUE(segments_meet({0, 0}, {4, 4}, {0, 4}, {4, 0}));
  EXPECT_FALSE(segments_meet({0, 0}, {1, 1}, {2, 2}, {3, 3}));
  EXPECT_TRUE(segments_meet({0, 0}, {2, 2}, {1, 1}, {3, 3}));
  EXPECT_TRUE(segments_meet({0, 0}, {2, 0}, {1, 0}, {1, 5}));
  EXPECT_TRUE(segments_meet({0, 0}, {2, 0}, {2, 0}, {3, 9}));
  EXPECT_FALSE(segments_meet({0, 0}, {2, 0}, {0, 1}, {2, 1}));
  EXPECT_FALSE(segments_meet({0, 0}, {2, 0}, {3, 0}, {3, 5}));
  EXPECT_TRUE(segments_meet({1, 1}, {1, 1}, {0, 0}, {2, 2}));
}

Point3 translate(const Point3& p, const Point3& by) {
  return {p[0] + by[0], p[1] + by[1], p[2] + by[2]};
}
Point2 flat(const Point3& p) {
  return {p[0], p[1]};
}

TEST(Predicates, TranslationChangesNothing) {
  for (const std::int32_t reach : {2, 1000, most / 2}) {
    RandomPoints points(reach);
    for (int i = 0; i < 500; ++i) {
      const Point3 a = points.next(), b = points.next(), c = points.next(), d = points.next();
      const Point3 by = points.next();
      const Point3 a1 = translate(a, by), b1 = translate(b, by), c1 = translate(c, by), d1 = translate(d, by);
      EXPECT_EQ(normal_of(a1, b1, c1), normal_of(a, b, c));
      EXPECT_EQ(orientation(a1, b1, c1, d1), orientation(a, b, c, d));
      EXPECT_EQ(turn(flat(a1), flat(b1), flat(c1)), turn(flat(a), flat(b), flat(c)));
      EXPECT_EQ(segments_meet(flat(a1), flat(b1), flat(c1), flat(d1)),
                segments_meet(flat(a), flat(b), flat(c), flat(d)));
      EXPECT_EQ(plane_through(a1, b1, c1).at(d1), plane_through(a, b, c).at(d));
    }
  }
}

TEST(Predicates, AreasAndVolumesAdd) {
  for (const std::int32_t reach : {2, 1000, most}) {
    RandomPoints points(reach);
    for (int i = 0; i < 500; ++i) {
      const Point3 a = points.next(), b = points.next(), c = points.next(), d = points.next(),
                   p = points.next();
      EXPECT_EQ(turn(flat(a), flat(b), flat(c)), turn(flat(p), flat(a), flat(b)) +
                                                     turn(flat(p), flat(b), flat(c)) +
                                                     turn(flat(p), flat(c), flat(a)));
      EXPECT_EQ(orientation(a, b, c, d), orientation(p, b, c, d) + orientation(a, p, c, d) +
                                             orientation(a, b, p, d) + orientation(a, b, c, p));
      EXPECT_EQ(turn(flat(a), flat(b), flat(b)), 0);
      EXPECT_EQ(orientation(a, b, c, b), 0);
    }
  }
}

// All pairs of segments between the points of a small lattice. Two convex sets are disjoint iff their projections on some line
// are; for
// segments a line along or perpendicular to one that joins two of the four ends suffices.
TEST(Predicates, SegmentsMeetInAnyOrder) {
  std::vector<Point2> lattice;
  for (std::int32_t x = 0; x < 4; ++x) {
    for (std::int32_t y = 0; y < 3; ++y) lattice.push_back({x, y});
  }
  for (const Point2& a : lattice) {
    for (const Point2& b : lattice) {
      for (const Point2& p : lattice) {
        EXPECT_EQ(on_segment(a, b, p), on_segment(b, a, p));
        EXPECT_EQ(segments_meet(a, b, p, p), on_segment(a, b, p));
        for (const Point2& q : lattice) {
          const bool meet = segments_meet(a, b, p, q);
          ASSERT_EQ(segments_meet(b, a, p, q), meet);
          ASSERT_EQ(segments_meet(a, b, q, p), meet);
          ASSERT_EQ(segments_meet(p, q, a, b), meet);
          bool apart = false;
          const Point2 ends[] = {a, b, p, q};
          for (const Point2& m : ends) {
            for (const Point2& n : ends) {
              for (const Point2& way : {Point2{n[0] - m[0], n[1] - m[1]}, Point2{n[1] - m[1], m[0] - n[0]}}) {
                const auto at = [&](const Point2& s) { return way[0] * s[1] - way[1] * s[0]; };
                apart = apart || std::max(at(a), at(b)) < std::min(at(p), at(q)) ||
                        std::max(at(p), at(q)) < std::min(at(a), at(b));
              }
            }
          }
          ASSERT_EQ(meet, !apart) << a[0] << a[1] << ' ' << b[0] << b[1] << ' ' << p[0] << p[1] << ' ' << q[0]
                                  << q[1];
        }
      }
    }
  }
}

// Stars around the origin do not cross themselves; the angle between two corners locates a point.
TEST(Predicates, PlacesInAStarDoNotDependOnItsStart) {
  constexpr std::array<Point2, 8> ways{
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
  std::mt19937 random(11);
  for (int round = 0; round < 50; ++round) {
    std::vector<Point2> ring;
    for (const Point2& way : ways) {
      const auto far = static_cast<std::int32_t>(random() % 6) + 1;
      ring.push_back({way[0] * far, way[1] * far});
    }
    std::vector<Point2> reversed(ring.rbegin(), ring.rend());
    std::vector<Point2> later(ring);
    std::rotate(later.begin(), later.begin() + 1 + static_cast<std::ptrdiff_t>(random() % 7), later.end());
    EXPECT_EQ(doubled_area(later), doubled_area(ring));
    EXPECT_EQ(doubled_area(reversed), -doubled_area(ring));
    for (std::int32_t x = -7; x <= 7; ++x) {
      for (std::int32_t y = -7; y <= 7; ++y) {
        const Point2 p{x, y};
        int expected =
            -1;  // inside iff in the triangle of the origin and two corners, without its outer side
        for (std::size_t i = 0; i < ring.size(); ++i) {
          const Point2& a = ring[i];
          const Point2& b = ring[(i + 1) % ring.size()];
          if (on_segment(a, b, p)) expected = 0;
          if (turn({0, 0}, a, p) >= 0 && turn({0, 0}, b, p) <= 0 && turn(a, b, p) > 0) expected = 1;
        }
        ASSERT_EQ(locate_in_ring(ring, p), expected) << x << ' ' << y;
        ASSERT_EQ(locate_in_ring(reversed, p), expected);
        ASSERT_EQ(locate_in_ring(later, p), expected);
      }
    }
  }
}

// Midpoints of all unit squares, compared with a count of crossings along x, for a ring with a bay.
TEST(Predicates, PointsAreLocatedInARing) {
  const std::vector<Point2> ring{{0, 0}, {10, 0}, {10, 10}, {5, 3}, {0, 10}};
  EXPECT_EQ(doubled_area(ring), 130);
  for (std::size_t start = 0; start < ring.size(); ++start) {
    for (const bool backwards : {false, true}) {
      std::vector<Point2> turned;
      for (std::size_t i = 0; i < ring.size(); ++i) turned.push_back(ring[(start + i) % ring.size()]);
      if (backwards) std::reverse(turned.begin(), turned.end());
      EXPECT_EQ(doubled_area(turned), backwards ? -130 : 130);
      EXPECT_EQ(locate_in_ring(turned, {5, 2}), 1);
      EXPECT_EQ(locate_in_ring(turned, {5, 3}), 0);
      EXPECT_EQ(locate_in_ring(turned, {5, 4}), -1);
      EXPECT_EQ(locate_in_ring(turned, {5, 0}), 0);
      EXPECT_EQ(locate_in_ring(turned, {0, 5}), 0);
      EXPECT_EQ(locate_in_ring(turned, {-1, 10}), -1);
      EXPECT_EQ(locate_in_ring(turned, {1, 3}), 1);
      EXPECT_EQ(locate_in_ring(turned, {11, 3}), -1);
      EXPECT_EQ(locate_in_ring(turned, {5, 10}), -1);
      EXPECT_EQ(locate_in_ring(turned, {10, 10}), 0);
    }
  }
}

}  // namespace
}  // namespace sightline::geometry
