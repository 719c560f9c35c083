// Laws and hand-computed cases of the twin's masks. Expectations are the laws of a routine (a cut is on its line, a mask is
// inside both of
// its parents), or numbers computed by hand, never its own output.
#include "host/programs/jones/twin/mask.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "tests/support/dice.hpp"

namespace sightline::programs::jones {
namespace {

std::int64_t turn(ScreenPoint a, ScreenPoint b, ScreenPoint p) {
  return std::int64_t{b.x - a.x} * (p.y - a.y) - std::int64_t{b.y - a.y} * (p.x - a.x);
}

Mask mask_of(std::vector<ScreenPoint> ring) {
  Mask mask;
  mask.count = static_cast<int>(ring.size());
  mask.xlo = mask.xhi = ring[0].x;
  mask.ylo = mask.yhi = ring[0].y;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    mask.vertices[i] = ring[i];
    mask.xlo = std::min(mask.xlo, ring[i].x);
    mask.xhi = std::max(mask.xhi, ring[i].x);
    mask.ylo = std::min(mask.ylo, ring[i].y);
    mask.yhi = std::max(mask.yhi, ring[i].y);
  }
  return mask;
}

// Strictly convex, counter-clockwise, with capacity for the vertices that a clip adds: the hull of five points.
std::vector<ScreenPoint> convex_ring(Dice& dice, std::int32_t size) {
  std::vector<ScreenPoint> points;
  for (int i = 0; i < 5; ++i) points.push_back({dice(-size, size), dice(-size, size)});
  std::sort(points.begin(), points.end(), [](auto a, auto b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  std::vector<ScreenPoint> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t base = hull.size();
    for (const ScreenPoint p : points) {
      while (hull.size() >= base + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

double doubled_area(std::span<const ScreenPoint> ring) {
  std::int64_t sum = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) sum += turn(ring[0], ring[i], ring[i + 1]);
  return static_cast<double>(sum);
}

TEST(JonesClip2, CutsAtTheWindow) {
  Operations operations;
  const auto piece = clip2(mask_of(window_of(Pass::mono, 512, 1)), {{-2000, 0}, {2000, 500}}, operations);
  // y = 500 * 976 / 4000 = 122; then 122 + 378 * 2046 / 3024 = 377.75
  EXPECT_EQ(piece, (ScreenSegment{{-1024, 122}, {1022, 378}}));
  EXPECT_EQ(operations.line_box.muldivs, 2U);
  EXPECT_EQ(operations.line_sloped.products, 0U);
}

TEST(JonesClip2, CutsAtASlopedEdge) {
  Operations operations;
  const Mask triangle = mask_of({{0, 0}, {100, 0}, {0, 100}});
  EXPECT_EQ(clip2(triangle, {{-50, 40}, {150, 40}}, operations), (ScreenSegment{{0, 40}, {60, 40}}));
  EXPECT_EQ(clip2(triangle, {{60, 60}, {90, 90}}, operations), std::nullopt);
}

TEST(JonesClip2, KeepsALineOnTheBoundaryButNotAPoint) {
  Operations operations;
  const Mask triangle = mask_of({{0, 0}, {100, 0}, {0, 100}});
  EXPECT_EQ(clip2(triangle, {{20, 80}, {70, 30}}, operations), (ScreenSegment{{20, 80}, {70, 30}}));
  EXPECT_EQ(clip2(triangle, {{-20, 0}, {120, 0}}, operations), (ScreenSegment{{0, 0}, {100, 0}}));
  EXPECT_EQ(clip2(triangle, {{100, 0}, {100, 50}}, operations), std::nullopt);
}

TEST(JonesClip2, PieceLiesInTheMaskAndOnTheLine) {
  Dice dice(4);
  Operations operations;
  int pieces = 0;
  for (int i = 0; i < 20000; ++i) {
    const Mask mask = mask_of(convex_ring(dice, 1000));
    if (mask.xlo == mask.xhi || mask.ylo == mask.yhi || mask.count < 3) continue;
    const ScreenSegment line{{dice(-3000, 3000), dice(-3000, 3000)}, {dice(-3000, 3000), dice(-3000, 3000)}};
    const auto piece = clip2(mask, line, operations);
    if (!piece) continue;
    ++pieces;
    const auto [xlo, xhi] = std::minmax({line.a.x, line.b.x});
    const auto [ylo, yhi] = std::minmax({line.a.y, line.b.y});
    const double length = std::hypot(line.b.x - line.a.x, line.b.y - line.a.y);
    for (const ScreenPoint p : {piece->a, piece->b}) {
      EXPECT_TRUE(mask.xlo <= p.x && p.x <= mask.xhi && mask.ylo <= p.y && p.y <= mask.yhi);
      EXPECT_TRUE(xlo <= p.x && p.x <= xhi && ylo <= p.y && p.y <= yhi);
      // Each cut rounds by at most half a unit per axis, and an end is cut by at most four lines.
      EXPECT_LE(std::abs(static_cast<double>(turn(line.a, line.b, p))), 4 * length);
    }
  }
  EXPECT_GT(pieces, 2000);
}

TEST(JonesIntersect, AMaskIntersectedWithItselfIsUnchanged) {
  Dice dice(5);
  Operations operations;
  for (int i = 0; i < 5000; ++i) {
    const auto ring = convex_ring(dice, 1000);
    if (ring.size() < 3) continue;
    const Intersection same = intersect(mask_of(ring), ring, operations);
    ASSERT_EQ(same.outcome, MaskOutcome::visible);
    EXPECT_EQ(same.mask, mask_of(ring));
  }
  EXPECT_EQ(operations.mask_box.muldivs + operations.mask_sloped.muldivs, 0U);
}

// The exact area by Green's theorem over the clipped polygon in doubles: independent of the integer clip.
double exact_doubled_area(const Mask& mask, std::vector<std::pair<double, double>> polygon) {
  const auto edges = mask.ring();
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const ScreenPoint a = edges[e], b = edges[(e + 1) % edges.size()];
    std::vector<std::pair<double, double>> kept;
    const auto side = [&](auto p) { return (b.x - a.x) * (p.second - a.y) - (b.y - a.y) * (p.first - a.x); };
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const auto p = polygon[i], q = polygon[(i + 1) % polygon.size()];
      if (side(p) >= 0) kept.push_back(p);
      if ((side(p) >= 0) != (side(q) >= 0)) {
        const double t = side(p) / (side(p) - side(q));
        kept.emplace_back(p.first + t * (q.first - p.first), p.second + t * (q.second - p.second));
      }
    }
    polygon = kept;
  }
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto p = polygon[i], q = polygon[(i + 1) % polygon.size()];
    sum += p.first * q.second - p.second * q.first;
  }
  return sum;
}

TEST(JonesIntersect, LiesInBothAndHasTheirCommonArea) {
  Dice dice(6);
  Operations operations;
  int visible = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto ring = convex_ring(dice, 1000);
    const auto window = convex_ring(dice, 1000);
    if (ring.size() < 3 || window.size() < 3) continue;
    const Mask mask = mask_of(window), other = mask_of(ring);
    const Intersection both = intersect(mask, ring, operations);
    ASSERT_NE(both.outcome, MaskOutcome::too_many_vertices);
    const double exact = exact_doubled_area(mask, [&] {
      std::vector<std::pair<double, double>> polygon;
      for (const ScreenPoint p : ring) polygon.emplace_back(p.x, p.y);
      return polygon;
    }());
    if (both.outcome == MaskOutcome::empty) {
      EXPECT_LT(exact, 8000) << "at most a sliver four thousand half points long and one wide";
      continue;
    }
    ++visible;
    const Mask& m = both.mask;
    EXPECT_TRUE(m.xlo >= mask.xlo && m.xhi <= mask.xhi && m.ylo >= mask.ylo && m.yhi <= mask.yhi);
    EXPECT_TRUE(m.xlo >= other.xlo && m.xhi <= other.xhi && m.ylo >= other.ylo && m.yhi <= other.yhi);
    const double perimeter = 2.0 * (m.xhi - m.xlo + m.yhi - m.ylo);
    EXPECT_NEAR(doubled_area(m.ring()), exact, 2 * perimeter + 40);
    for (int v = 0; v < m.count; ++v) {
      const auto at = [&](int k) { return m.vertices[static_cast<std::size_t>((v + k) % m.count)]; };
      // Convex except for the rounding of a vertex by a unit per axis.
      EXPECT_GE(static_cast<double>(turn(at(0), at(1), at(2))), -2 * perimeter);
    }
  }
  EXPECT_GT(visible, 10000);
}

TEST(JonesIntersect, TouchingIsEmpty) {
  Operations operations;
  const Mask mask = mask_of({{-10, -10}, {10, -10}, {10, 10}, {-10, 10}});
  const auto outcome = [&](std::vector<ScreenPoint> ring) {
    return intersect(mask, ring, operations).outcome;
  };
  EXPECT_EQ(outcome({{10, -10}, {30, -10}, {30, 10}, {10, 10}}), MaskOutcome::empty) << "a common side";
  EXPECT_EQ(outcome({{10, 10}, {30, 10}, {30, 30}, {10, 30}}), MaskOutcome::empty) << "a common corner";
  EXPECT_EQ(outcome({{20, 0}, {40, 0}, {0, 40}, {0, 20}}), MaskOutcome::empty)
      << "a sloped side through a corner";
  EXPECT_EQ(outcome({{9, -10}, {30, -10}, {30, 10}, {9, 10}}), MaskOutcome::visible);
}

// J6: a corner of the ring exactly on an edge of the mask is one vertex of the result.
TEST(JonesIntersect, CornerOnAnEdgeIsOneVertex) {
  Operations operations;
  const Mask mask = mask_of({{-10, -10}, {10, -10}, {10, 10}, {-10, 10}});
  const Intersection both = intersect(mask, std::vector<ScreenPoint>{{0, -4}, {10, 0}, {0, 4}}, operations);
  ASSERT_EQ(both.outcome, MaskOutcome::visible);
  EXPECT_EQ(both.mask, mask_of({{0, -4}, {10, 0}, {0, 4}}));
}

// A square with bulging sides, each with `on_each_side` edges.
std::vector<ScreenPoint> many_corners(int on_each_side) {
  std::vector<ScreenPoint> ring, right, top, left;
  const int size = 100 * on_each_side;
  for (int i = 0; i < on_each_side; ++i) {
    const int along = 100 * i;
    const int bulge = 10 * i * (on_each_side - i);
    ring.push_back({along, -bulge});
    right.push_back({size + bulge, along});
    top.push_back({size - along, size + bulge});
    left.push_back({-bulge, size - along});
  }
  for (const auto& side : {right, top, left}) ring.insert(ring.end(), side.begin(), side.end());
  return ring;
}

TEST(JonesPolygonBuilder, HoldsSixteenPoints) {
  const auto ring = many_corners(4);
  PolygonBuilder polygon;
  for (const ScreenPoint p : ring) ASSERT_TRUE(polygon.append(p));
  EXPECT_TRUE(polygon.append(ring.back())) << "a repetition is no new point";
  EXPECT_FALSE(polygon.append(ring.front())) << "the 17th, before it could be dropped as equal to the first";
  EXPECT_EQ(polygon.points().size(), 16U);
}

TEST(JonesPolygonBuilder, CloseDropsARepetitionOfTheFirst) {
  PolygonBuilder polygon;
  polygon.close();
  EXPECT_TRUE(polygon.points().empty());
  ASSERT_TRUE(polygon.append({1, 2}));
  polygon.close();
  EXPECT_EQ(polygon.points().size(), 1U);
  ASSERT_TRUE(polygon.append({3, 4}) && polygon.append({1, 2}));
  polygon.close();
  EXPECT_EQ(polygon.points().size(), 2U);
}

TEST(JonesIntersect, ASeventeenthVertexIsTooMany) {
  Operations operations;
  const Mask mask = mask_of({{-900, -900}, {900, -900}, {900, 900}, {-900, 900}});
  const auto ring = many_corners(4);
  EXPECT_EQ(intersect(mask, ring, operations).outcome, MaskOutcome::visible);
  // A side of the mask removes one corner and adds two.
  Mask cut = mask;
  cut.xhi = 435;
  EXPECT_EQ(intersect(cut, ring, operations).outcome, MaskOutcome::too_many_vertices);
}

TEST(JonesMask, CountsItsSlopedEdges) {
  EXPECT_EQ(sloped_edges(mask_of(Window())), 0);
  EXPECT_EQ(sloped_edges(mask_of({{0, 0}, {100, 0}, {0, 100}})), 1);
  EXPECT_EQ(sloped_edges(mask_of({{0, 0}, {100, -50}, {100, 200}, {0, 100}})), 2);
}

// Of a square, a corner in the middle of a side and a reflex corner are omitted, wherever the ring begins.
TEST(JonesMask, CornersThatDoNotTurnLeftAreOmitted) {
  const std::vector<ScreenPoint> square{{0, 0}, {8, 0}, {8, 8}, {0, 8}};
  const std::vector<ScreenPoint> ring{{0, 0}, {4, 0}, {8, 0}, {7, 4}, {8, 8}, {0, 8}};
  for (std::size_t first = 0; first < ring.size(); ++first) {
    PolygonBuilder polygon;
    for (std::size_t i = 0; i < ring.size(); ++i) EXPECT_TRUE(polygon.append(ring[(first + i) % ring.size()]));
    polygon.drop_hollow_corners();
    ASSERT_EQ(polygon.points().size(), square.size());
    EXPECT_TRUE(std::is_permutation(square.begin(), square.end(), polygon.points().begin()));
    for (std::size_t i = 0; i < square.size(); ++i)
      EXPECT_GT(turn(polygon.points()[i], polygon.points()[(i + 1) % 4], polygon.points()[(i + 2) % 4]), 0);
  }
}

}  // namespace
}  // namespace sightline::programs::jones
