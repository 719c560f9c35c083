// Lines in which faces cross: known by hand, and compared with an independent computation in rational numbers.
#include "host/scene/check/crossings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "host/scene/check/apart_bodies.hpp"
#include "host/scene/check/poly_scene.hpp"
#include "host/scene/model/face_cut.hpp"

namespace sightline::scene {
namespace {

void add_box(PolyScene& scene, const PolyPoint& low, const PolyPoint& high) {
  const auto first = static_cast<VertexIndex>(scene.vertices.size());
  for (int i = 0; i < 8; ++i)
    scene.vertices.push_back({(i & 1) != 0 ? high[0] : low[0], (i & 2) != 0 ? high[1] : low[1], (i & 4) != 0 ? high[2] : low[2]});
  PolyBody body;
  for (const auto& face : std::vector<std::vector<VertexIndex>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    body.faces.emplace_back();
    for (const VertexIndex v : face) body.faces.back().outline.push_back(first + v);
  }
  scene.bodies.push_back(body);
}

void add_sheet(PolyScene& scene, const std::vector<PolyPoint>& points) {
  PolyBody body;
  body.sheet = true;
  body.faces.emplace_back();
  for (const PolyPoint& p : points) {
    body.faces[0].outline.push_back(static_cast<VertexIndex>(scene.vertices.size()));
    scene.vertices.push_back(p);
  }
  scene.bodies.push_back(body);
}

std::set<std::set<PolyPoint>> lines_of(const PolyScene& scene) {
  std::set<std::set<PolyPoint>> lines;
  for (const Crossing& crossing : crossings_of(scene))
    lines.insert({rounded(scene.vertices, crossing.ends[0]), rounded(scene.vertices, crossing.ends[1])});
  return lines;
}

TEST(Crossings, ABarThroughABox) {
  PolyScene scene;
  add_box(scene, {0, 0, 0}, {100, 100, 100});
  add_box(scene, {40, 40, -50}, {60, 60, 150});
  ASSERT_TRUE(check_poly_scene(scene).empty());
  std::set<std::set<PolyPoint>> expected;
  for (const std::int32_t z : {0, 100}) {
    const std::array<PolyPoint, 4> ring{PolyPoint{40, 40, z}, {60, 40, z}, {60, 60, z}, {40, 60, z}};
    for (std::size_t i = 0; i < 4; ++i) expected.insert({ring[i], ring[(i + 1) % 4]});
  }
  EXPECT_EQ(lines_of(scene), expected);
  EXPECT_EQ(crossings_of(scene, 1).size(), 1U);
  const PolyScene drawn = with_crossings(scene);
  EXPECT_EQ(drawn.crossings.size(), 8U);
  EXPECT_EQ(drawn.vertices.size(), 16U + 16U);
}

// Two pyramids on one base, turned against each other: beyond the crossing one of them is inside out.
TEST(Crossings, ABodyThatPassesThroughItselfIsASheet) {
  PolyScene scene;
  add_box(scene, {90, 90, 90}, {100, 100, 100});
  scene.vertices.insert(scene.vertices.end(), {{0, 0, 0}, {4, 0, 0}, {0, 0, 4}, {1, 4, 1}, {6, 3, 2}});
  PolyBody body;
  for (const auto& face : std::vector<std::vector<VertexIndex>>{{8, 11, 9}, {9, 11, 10}, {10, 11, 8}, {9, 12, 8}, {10, 12, 9}, {8, 12, 10}})
    body.faces.push_back({face, {}});
  scene.bodies.push_back(body);
  const PolyScene drawn = with_crossings(scene);
  EXPECT_FALSE(drawn.crossings.empty());
  EXPECT_FALSE(drawn.bodies[0].sheet);
  EXPECT_TRUE(drawn.bodies[1].sheet);
}

TEST(Crossings, AnEdgeThatSticksIntoABox) {
  PolyScene scene;
  add_box(scene, {0, 0, 0}, {100, 100, 100});
  add_sheet(scene, {{50, 50, 50}, {150, 50, 50}, {150, 90, 50}, {50, 90, 50}});
  EXPECT_EQ(lines_of(scene), (std::set<std::set<PolyPoint>>{{{100, 50, 50}, {100, 90, 50}}}));
}

TEST(Crossings, TouchingIsNotACrossing) {
  PolyScene scene;
  add_box(scene, {0, 0, 0}, {100, 100, 100});
  add_box(scene, {100, 0, 0}, {200, 100, 100});    // a whole face
  add_box(scene, {20, 20, 100}, {80, 80, 150});    // part of a face
  add_box(scene, {-50, -50, -50}, {0, 0, 0});      // a corner
  add_box(scene, {-50, 100, 0}, {0, 150, 100});    // an edge
  add_box(scene, {30, 30, 30}, {60, 60, 60});      // within
  add_sheet(scene, {{100, 30, 130}, {150, 30, 130}, {150, 30, 100}});  // an edge that ends on an edge
  add_sheet(scene, {{20, 50, 0}, {80, 50, 0}, {50, 50, -50}});         // an edge that lies on a face
  EXPECT_TRUE(crossings_of(scene).empty());
}

TEST(Crossings, ThroughAHoleThereIsNone) {
  PolyScene scene;
  add_sheet(scene, {{0, 0, 0}, {100, 0, 0}, {100, 100, 0}, {0, 100, 0}});
  scene.vertices.insert(scene.vertices.end(), {{20, 20, 0}, {20, 80, 0}, {80, 80, 0}, {80, 20, 0}});
  scene.bodies[0].faces[0].holes = {{4, 5, 6, 7}};
  add_sheet(scene, {{50, 30, -10}, {50, 70, -10}, {50, 70, 10}, {50, 30, 10}});
  EXPECT_TRUE(crossings_of(scene).empty());
  add_sheet(scene, {{60, -10, -10}, {60, 110, -10}, {60, 110, 10}, {60, -10, 10}});
  EXPECT_EQ(lines_of(scene), (std::set<std::set<PolyPoint>>{{{60, 0, 0}, {60, 20, 0}}, {{60, 80, 0}, {60, 100, 0}}}));
}

// The plane of the other face contains corners: through a corner, and along a diagonal.
TEST(Crossings, ThroughCorners) {
  PolyScene scene;
  add_sheet(scene, {{0, 0, 0}, {100, 0, 0}, {100, 100, 0}, {0, 100, 0}});
  add_sheet(scene, {{0, 0, -20}, {100, 100, -20}, {100, 100, 20}, {0, 0, 20}});
  EXPECT_EQ(lines_of(scene), (std::set<std::set<PolyPoint>>{{{0, 0, 0}, {100, 100, 0}}}));
  PolyScene kite;
  add_sheet(kite, {{0, 0, 0}, {100, 0, 0}, {100, 100, 0}, {0, 100, 0}});
  add_sheet(kite, {{0, 50, 0}, {50, 50, -20}, {80, 50, 0}, {50, 50, 20}});
  EXPECT_EQ(lines_of(kite), (std::set<std::set<PolyPoint>>{{{0, 50, 0}, {80, 50, 0}}}));
}

// Random triangles: two cross along a line if and only if the sides of one or the other pass through its inside twice. The ends,
// in
// doubles, are those points.
TEST(Crossings, OfRandomTrianglesAreWhereSidesPassThroughTheOther) {
  std::mt19937 random(4);
  using Point = std::array<double, 3>;
  const auto minus = [](const PolyPoint& a, const PolyPoint& b) {
    return Point{double(a[0] - b[0]), double(a[1] - b[1]), double(a[2] - b[2])};
  };
  const auto cross = [](const Point& a, const Point& b) {
    return Point{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const auto dot = [](const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  std::size_t crossing = 0;
  for (int round = 0; round < 4000; ++round) {
    PolyScene scene;
    std::array<std::vector<PolyPoint>, 2> triangles;
    for (auto& triangle : triangles) {
      for (int i = 0; i < 3; ++i) {
        PolyPoint p{};
        for (std::int32_t& c : p) c = static_cast<std::int32_t>(random() % 2001) - 1000;
        triangle.push_back(p);
      }
      add_sheet(scene, triangle);
    }
    // Sides of one that pass through the inside of the other (no determinant is 0 in these rounds).
    std::vector<Point> points;
    for (int t = 0; t < 2; ++t) {
      const auto& face = triangles[static_cast<std::size_t>(t)];
      const auto& other = triangles[static_cast<std::size_t>(1 - t)];
      const Point normal = cross(minus(face[1], face[0]), minus(face[2], face[0]));
      for (std::size_t i = 0; i < 3; ++i) {
        const PolyPoint& p = other[i];
        const PolyPoint& q = other[(i + 1) % 3];
        const double a = dot(normal, minus(p, face[0]));
        const double b = dot(normal, minus(q, face[0]));
        if ((a > 0) == (b > 0)) continue;
        int turn = 0;
        for (std::size_t k = 0; k < 3; ++k)
          turn += dot(cross(minus(face[k], p), minus(face[(k + 1) % 3], p)), minus(q, p)) > 0 ? 1 : -1;
        if (std::abs(turn) != 3) continue;
        const double s = a / (a - b);
        points.push_back({p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1]), p[2] + s * (q[2] - p[2])});
      }
    }
    const auto found = crossings_of(scene);
    if (points.size() != 2) {
      EXPECT_TRUE(points.empty() && found.empty()) << round;
      continue;
    }
    ++crossing;
    ASSERT_EQ(found.size(), 1U) << round;
    const auto distance = [](const Point& p, const Point& q) {
      return std::max({std::abs(p[0] - q[0]), std::abs(p[1] - q[1]), std::abs(p[2] - q[2])});
    };
    for (const CutPoint& end : found[0].ends) {
      const Point at = real(scene.vertices, end);
      EXPECT_LE(std::min(distance(at, points[0]), distance(at, points[1])), 1e-8) << round;
    }
  }
  EXPECT_GT(crossing, 500U);
}

// Every pair is found, for faces at any position and of any size.
TEST(Crossings, OfManyBodiesEqualThoseOfAllPairs) {
  std::mt19937 random(8);
  std::size_t pairs = 0;
  for (int round = 0; round < 20; ++round) {
    PolyScene scene;
    for (int i = 0; i < 30; ++i) {
      PolyPoint low{};
      PolyPoint high{};
      const std::int32_t size = i % 10 == 0 ? 5000 : 300;
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = static_cast<std::int32_t>(random() % 5000) + static_cast<std::int32_t>(k);
        high[k] = low[k] + 10 + static_cast<std::int32_t>(random() % static_cast<unsigned>(size));
      }
      add_box(scene, low, high);
    }
    std::set<std::array<std::uint32_t, 2>> expected;
    for (std::uint32_t a = 0; a < 30; ++a) {
      for (std::uint32_t b = a + 1; b < 30; ++b) {
        PolyScene pair;
        for (const std::uint32_t n : {a, b}) add_box(pair, scene.vertices[8 * n], scene.vertices[8 * n + 7]);
        for (const Crossing& crossing : crossings_of(pair))
          expected.insert({crossing.face_a + 6 * a, crossing.face_b - 6 + 6 * b});
      }
    }
    std::set<std::array<std::uint32_t, 2>> found;
    for (const Crossing& crossing : crossings_of(scene)) found.insert({crossing.face_a, crossing.face_b});
    EXPECT_EQ(found, expected) << round;
    pairs += expected.size();
  }
  EXPECT_GT(pairs, 20U);
}

// The cheap test must be correct whenever it returns true, for the bodies' boxes and for each body alone; and it returns true in
// clear
// cases.
TEST(AreBodiesApart, MatchesATestOfEveryPairOfBoxes) {
  std::mt19937 generator(11);
  const auto below = [&generator](std::uint32_t limit) { return static_cast<std::int32_t>(generator() % limit); };
  int apart = 0;
  for (int round = 0; round < 400; ++round) {
    PolyScene scene;
    std::vector<std::pair<PolyPoint, PolyPoint>> boxes;
    const int count = 1 + below(40);
    for (int b = 0; b < count; ++b) {
      PolyPoint low{};
      PolyPoint high{};
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = below(1000) - 500;
        high[k] = low[k] + 1 + below(round % 2 == 0 ? 30 : 300);
      }
      boxes.emplace_back(low, high);
      add_box(scene, low, high);
    }
    bool meet = false;
    for (std::size_t a = 0; a < boxes.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        bool common = true;
        for (std::size_t k = 0; k < 3; ++k)
          common = common && boxes[a].first[k] <= boxes[b].second[k] && boxes[b].first[k] <= boxes[a].second[k];
        meet = meet || common;
      }
    }
    ASSERT_EQ(are_plainly_apart(scene), !meet) << "round " << round;
    if (!meet) ++apart;
  }
  EXPECT_GT(apart, 50);
  EXPECT_LT(apart, 350);
}

TEST(AreBodiesApart, ANonConvexBodyIsNot) {
  PolyScene scene;
  // Two sheets of one body that pass through each other.
  add_sheet(scene, {{0, 0, 0}, {100, 0, 0}, {100, 100, 0}, {0, 100, 0}});
  EXPECT_TRUE(are_plainly_apart(scene));
  add_sheet(scene, {{50, 50, -40}, {50, 50, 40}, {50, 20, 40}, {50, 20, -40}});
  scene.bodies[0].faces.push_back(scene.bodies[1].faces[0]);
  scene.bodies.pop_back();
  EXPECT_FALSE(are_plainly_apart(scene));
  EXPECT_EQ(crossings_of(scene).size(), 1U);
}

TEST(AreBodiesApart, BodiesOfVeryDifferentSizes) {
  PolyScene scene;
  add_box(scene, {0, 0, 0}, {100000, 100000, 10});
  for (std::int32_t i = 0; i < 2000; ++i) {
    const std::int32_t x = 2000 * (i % 45);
    const std::int32_t y = 2000 * (i / 45);
    add_box(scene, {x, y, 20}, {x + 10, y + 10, 30});
  }
  (void)are_plainly_apart(scene);  // either result is correct, in little time
  EXPECT_TRUE(crossings_of(scene).empty());
  add_box(scene, {90001, 90001, 0}, {90005, 90005, 25});
  EXPECT_FALSE(are_plainly_apart(scene));
  EXPECT_EQ(crossings_of(scene).size(), 4U);
}

}  // namespace
}  // namespace sightline::scene
