// Pen order: the same lines are drawn, in an order compared with that of a simple algorithm.
#include "host/picture/pen_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace sightline::picture {
namespace {

const Paper whole_sheet{200, 200, 0, 0.2};

VectorDrawing sheet() {
  VectorDrawing drawing;
  drawing.width = drawing.height = 200;  // a unit is a millimetre
  drawing.layers = {{"visible", {0, 0, 0}}};
  return drawing;
}

void add_line(VectorDrawing& drawing, const std::vector<DrawingPoint>& points, std::uint32_t layer = 0) {
  drawing.lines.push_back({layer, static_cast<std::uint32_t>(drawing.points.size()), static_cast<std::uint32_t>(points.size())});
  drawing.points.insert(drawing.points.end(), points.begin(), points.end());
}

VectorDrawing random_lines(std::uint32_t seed, int count) {
  std::mt19937 random(seed);
  const auto place = [&] { return static_cast<float>(random() % 200'000) / 1000; };
  VectorDrawing drawing = sheet();
  for (int i = 0; i < count; ++i) {
    const DrawingPoint from{place(), place()};
    add_line(drawing, {from, {std::min(from.x + place() / 20, 200.0F), std::min(from.y + place() / 20, 200.0F)}});
  }
  return drawing;
}

using Segment = std::pair<std::pair<float, float>, std::pair<float, float>>;

// The number of times that every straight segment occurs, in either direction.
std::map<Segment, int> segments_of(const VectorDrawing& drawing) {
  std::map<Segment, int> segments;
  for (const DrawingLine& line : drawing.lines) {
    for (std::uint32_t i = 1; i < line.count; ++i) {
      const DrawingPoint& a = drawing.points[line.first + i - 1];
      const DrawingPoint& b = drawing.points[line.first + i];
      std::pair from{a.x, a.y};
      std::pair to{b.x, b.y};
      if (to < from) std::swap(from, to);
      ++segments[{from, to}];
    }
  }
  return segments;
}

// Nearest next with both ends, then every reversal of a part that shortens the way, until there is none: O(n^2) each.
double plain_way(const VectorDrawing& drawing) {
  struct Line {
    DrawingPoint from, to;
  };
  std::vector<Line> left;
  for (const DrawingLine& line : drawing.lines)
    left.push_back({drawing.points[line.first], drawing.points[line.first + line.count - 1]});
  const auto distance = [](DrawingPoint a, DrawingPoint b) { return std::hypot(double{a.x} - b.x, double{a.y} - b.y); };
  std::vector<Line> tour;
  DrawingPoint pen{0, 0};
  while (!left.empty()) {
    std::size_t best = 0;
    double nearest = 1e9;
    bool turned = false;
    for (std::size_t i = 0; i < left.size(); ++i) {
      for (const bool turn : {false, true}) {
        const double d = distance(pen, turn ? left[i].to : left[i].from);
        if (d >= nearest) continue;
        nearest = d;
        best = i;
        turned = turn;
      }
    }
    if (turned) std::swap(left[best].from, left[best].to);
    tour.push_back(left[best]);
    pen = tour.back().to;
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
  }
  const auto before = [&](std::size_t i) { return i == 0 ? DrawingPoint{0, 0} : tour[i - 1].to; };
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < tour.size(); ++i) {
      for (std::size_t j = i; j < tour.size(); ++j) {
        const bool last = j + 1 == tour.size();
        const double now = distance(before(i), tour[i].from) + (last ? 0 : distance(tour[j].to, tour[j + 1].from));
        const double then = distance(before(i), tour[j].to) + (last ? 0 : distance(tour[i].from, tour[j + 1].from));
        if (then >= now - 1e-9) continue;
        std::reverse(tour.begin() + static_cast<std::ptrdiff_t>(i), tour.begin() + static_cast<std::ptrdiff_t>(j) + 1);
        for (std::size_t k = i; k <= j; ++k) std::swap(tour[k].from, tour[k].to);
        changed = true;
      }
    }
  }
  double way = 0;
  for (std::size_t i = 0; i < tour.size(); ++i) way += distance(before(i), tour[i].from);
  return way;
}

TEST(PenOrder, IsNearlyAsShortAsASimpleGreedyTourWithReversals) {
  for (const int count : {30, 100, 400}) {
    for (std::uint32_t seed = 1; seed <= 4; ++seed) {
      const VectorDrawing drawing = random_lines(seed, count);
      const VectorDrawing ordered = in_pen_order(drawing, whole_sheet);
      EXPECT_EQ(segments_of(ordered), segments_of(drawing)) << count << ' ' << seed;
      EXPECT_LE(pen_travel(ordered, whole_sheet).up, 1.15 * plain_way(drawing)) << count << ' ' << seed;
    }
  }
}

TEST(PenOrder, EveryLineIsDrawnOnceForAnyNumber) {
  const VectorDrawing drawing = random_lines(9, 20'000);
  const VectorDrawing ordered = in_pen_order(drawing, whole_sheet, {.join = 0});
  EXPECT_EQ(segments_of(ordered), segments_of(drawing));
  EXPECT_LT(pen_travel(ordered, whole_sheet).up, pen_travel(drawing, whole_sheet).up / 50);
}

TEST(PenOrder, LinesThatMeetAreJoinedTheStraightestFirst) {
  VectorDrawing drawing = sheet();
  // A cross of four arms around one point, and a triangle side by side.
  add_line(drawing, {{100, 100}, {120, 100}});
  add_line(drawing, {{100, 100}, {100, 120}});
  add_line(drawing, {{80, 100}, {100, 100}});
  add_line(drawing, {{100, 80}, {100, 100.0005F}});  // almost there
  add_line(drawing, {{10, 10}, {20, 10}});
  add_line(drawing, {{15, 20}, {20, 10}});
  add_line(drawing, {{15, 20}, {10, 10}});
  const VectorDrawing ordered = in_pen_order(drawing, whole_sheet);
  ASSERT_EQ(ordered.lines.size(), 3U);
  EXPECT_EQ(ordered.lines[0].count, 4U);  // the triangle, closed
  EXPECT_EQ(ordered.points[ordered.lines[0].first], ordered.points[ordered.lines[0].first + 3]);
  EXPECT_EQ(ordered.lines[1].count, 2U);  // two arms, without the corner between them
  EXPECT_EQ(ordered.lines[2].count, 2U);
}

TEST(PenOrder, ShortGapsAreDrawnOnlyOnRequestAndNeverThoseOfDashes) {
  VectorDrawing drawing = sheet();
  drawing.layers.push_back({"hidden", {150, 150, 150}, 2});
  for (std::uint32_t layer = 0; layer < 2; ++layer)
    for (int i = 0; i < 5; ++i)
      add_line(drawing, {{10.0F + 10 * static_cast<float>(i), 50}, {19.5F + 10 * static_cast<float>(i), 50}}, layer);
  EXPECT_EQ(in_pen_order(drawing, whole_sheet).lines.size(), 10U);
  const VectorDrawing closed = in_pen_order(drawing, whole_sheet, {.min_gap = 0.6});
  EXPECT_EQ(closed.lines.size(), 1U + 5U);
  EXPECT_NEAR(pen_travel(closed, whole_sheet).down, 49.5 + 5 * 9.5, 1e-4);
  EXPECT_EQ(in_pen_order(drawing, whole_sheet, {.min_gap = 0.4}).lines.size(), 10U);
}

TEST(PenOrder, FlatCornersAreRemovedAndRoundLinesStay) {
  VectorDrawing drawing = sheet();
  add_line(drawing, {{0, 0}, {10, 10}, {20, 20}, {30, 30.0005F}, {40, 40}});
  std::vector<DrawingPoint> circle;
  for (int i = 0; i <= 90; ++i)
    circle.push_back({150 + 20 * static_cast<float>(std::cos(i * 0.0698131700797732)),
                      150 + 20 * static_cast<float>(std::sin(i * 0.0698131700797732))});
  add_line(drawing, circle);
  const VectorDrawing ordered = in_pen_order(drawing, whole_sheet);
  EXPECT_EQ(ordered.lines[0].count, 2U);
  EXPECT_GE(ordered.lines[1].count, 90U);
}

TEST(PenOrder, DotsLayersAndEmptyDrawings) {
  VectorDrawing drawing = sheet();
  EXPECT_TRUE(in_pen_order(drawing, whole_sheet).lines.empty());
  drawing.layers.push_back({"second", {0, 0, 0}});
  add_line(drawing, {{5, 5}}, 1);
  add_line(drawing, {{100, 100}});
  add_line(drawing, {{5, 5}});
  const VectorDrawing ordered = in_pen_order(drawing, whole_sheet);
  ASSERT_EQ(ordered.lines.size(), 3U);
  EXPECT_EQ(ordered.points[ordered.lines[0].first].x, 5);
  EXPECT_EQ(ordered.lines[2].layer, 1U);
  const PenTravel travel = pen_travel(ordered, whole_sheet);
  EXPECT_EQ(travel.lifts, 3U);
  EXPECT_EQ(travel.pens, 2U);
  EXPECT_NEAR(travel.up, std::sqrt(2) * (5 + 95 + 95), 1e-9);
}

// 100 mm at 100 mm/s with 100 mm/s2: one second and one second of ramps; 1 mm never reaches that speed.
TEST(PenOrder, TimeIsThatOfATrapezoid) {
  VectorDrawing drawing = sheet();
  add_line(drawing, {{0, 0}, {100, 0}, {100, 1}});
  EXPECT_NEAR(plot_seconds(drawing, whole_sheet, {100, 200, 100, 0.5, 3}), 3 + 2 * 0.5 + 0 + (1 + 1) + 2 * std::sqrt(0.01), 1e-9);
}

}  // namespace
}  // namespace sightline::picture
