// The triangulation of scattered points: its laws, checked point by point, and heights that are known where points are not.
#include "host/scene/heights/delaunay.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "host/scene/heights/interpolate.hpp"
#include "host/scene/heights/read_grid.hpp"

namespace sightline::scene {
namespace {

using geometry::Point2;
using geometry::turn;

TEST(InCircle, BesideOnAndInside) {
  const Point2 a{0, 0};
  const Point2 b{10, 0};
  const Point2 c{0, 10};
  EXPECT_EQ(in_circle(a, b, c, {10, 10}), 0);
  EXPECT_EQ(in_circle(a, b, c, {9, 9}), 1);
  EXPECT_EQ(in_circle(a, b, c, {11, 10}), -1);
  // 5 5 and 13 0 are on the circle around 0 0 of radius 13 as 5 12 is: exact at the limit of coordinates.
  constexpr std::int32_t far = (1 << 18) - 14;
  const auto at = [](std::int32_t x, std::int32_t y) { return Point2{far + x, -far + y}; };
  EXPECT_EQ(in_circle(at(13, 0), at(5, 12), at(-12, 5), at(0, -13)), 0);
  EXPECT_EQ(in_circle(at(13, 0), at(5, 12), at(-12, 5), at(0, -12)), 1);
}

// Twice the area of the convex hull (monotone chain).
std::int64_t doubled_hull_area(std::vector<Point2> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<Point2> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t begin = hull.size();
    for (const Point2& p : points) {
      while (hull.size() >= begin + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  std::int64_t area = 0;
  for (std::size_t i = 2; i < hull.size(); ++i) area += turn(hull[0], hull[i - 1], hull[i]);
  return area;
}

// Counterclockwise triangles with empty circles, every side once in each direction at most, which cover the hull and have all points.
void expect_delaunay(const std::vector<Point2>& points) {
  const auto triangles = delaunay(points);
  std::int64_t area = 0;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  std::vector<Point2> used;
  for (const auto& t : triangles) {
    area += turn(points[t[0]], points[t[1]], points[t[2]]);
    ASSERT_GT(turn(points[t[0]], points[t[1]], points[t[2]]), 0);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(++sides[std::pair(t[i], t[(i + 1) % 3])], 1);
      used.push_back(points[t[i]]);
    }
    for (const Point2& p : points) ASSERT_LE(in_circle(points[t[0]], points[t[1]], points[t[2]], p), 0);
  }
  EXPECT_EQ(area, doubled_hull_area(points));
  std::vector<Point2> all = points;
  for (auto* const list : {&all, &used}) {
    std::sort(list->begin(), list->end());
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  if (!triangles.empty()) {
    EXPECT_EQ(all, used);
  }
}

TEST(Delaunay, RandomPoints) {
  std::mt19937 random(7);
  for (int round = 0; round < 300; ++round) {
    // Small ranges have many points on one line, on one circle and in one place.
    const std::int32_t range = round % 3 == 0 ? 4 : round % 3 == 1 ? 30 : (1 << 18) - 1;
    std::vector<Point2> points;
    for (int i = 0; i < 3 + round % 60; ++i) {
      const auto coordinate = [&] { return static_cast<std::int32_t>(random() % static_cast<std::uint32_t>(2 * range + 1)) - range; };
      points.push_back({coordinate(), coordinate()});
    }
    expect_delaunay(points);
  }
}

TEST(Delaunay, Degenerate) {
  EXPECT_TRUE(delaunay({}).empty());
  EXPECT_TRUE(delaunay(std::vector<Point2>{{0, 0}, {1, 1}}).empty());
  EXPECT_TRUE(delaunay(std::vector<Point2>{{0, 0}, {1, 1}, {2, 2}, {7, 7}, {3, 3}}).empty()) << "on one line";
  EXPECT_TRUE(delaunay(std::vector<Point2>{{5, 5}, {5, 5}, {5, 5}}).empty()) << "in one place";
  EXPECT_EQ(delaunay(std::vector<Point2>{{0, 0}, {1, 0}, {0, 1}, {0, 0}}).size(), 1U);
  std::vector<Point2> grid;
  for (std::int32_t x = 0; x < 20; ++x)
    for (std::int32_t y = 0; y < 20; ++y) grid.push_back({x, y});
  EXPECT_EQ(delaunay(grid).size(), 2U * 19 * 19);
  expect_delaunay(grid);
  std::vector<Point2> line_and_point{{50, 1}};
  for (std::int32_t x = 0; x < 100; ++x) line_and_point.push_back({x, 0});
  EXPECT_EQ(delaunay(line_and_point).size(), 99U);
  expect_delaunay(line_and_point);
}

// A plane is the same on every triangulation.
TEST(Interpolated, APlaneStaysOne) {
  std::mt19937 random(3);
  const auto place = [&random] { return static_cast<double>(random() % 100001) / 1000; };
  std::vector<ScatteredPoint> points{{0, 0, 0}, {100, 0, 0}, {0, 100, 0}, {100, 100, 0}};
  for (int i = 0; i < 500; ++i) points.push_back({place(), place(), 0});
  for (ScatteredPoint& point : points) point.height = 3 * point.x - 2 * point.y + 7;
  const auto grid = interpolated(points, {21, 11}, "points");
  ASSERT_TRUE(grid);
  EXPECT_EQ(grid->domain_x, (Interval{0, 100}));
  for (std::size_t slice = 0; slice < 11; ++slice)
    for (std::size_t point = 0; point < 21; ++point)
      EXPECT_NEAR(grid->height(point, slice), 3 * 5.0 * static_cast<double>(point) - 2 * 10.0 * static_cast<double>(slice) + 7, 0.01);
}

TEST(Interpolated, HolesOutsideOfTheHull) {
  const auto grid = interpolated({{0, 0, 1}, {4, 0, 2}, {0, 4, 3}}, {5, 5}, "points");
  ASSERT_TRUE(grid);
  for (std::size_t slice = 0; slice < 5; ++slice)
    for (std::size_t point = 0; point < 5; ++point) {
      if (point + slice > 4) {
        EXPECT_TRUE(std::isnan(grid->height(point, slice)));
      } else {
        EXPECT_NEAR(grid->height(point, slice), 1 + static_cast<double>(point) / 4 + static_cast<double>(slice) / 2, 1e-9);
      }
    }
  EXPECT_EQ(grid->note, "3 points, 1 triangle, a grid of 5 x 5, 10 places outside of the points");
}

std::string error_of(std::string_view text) {
  const auto grid = read_height_grid(text, "points", {.triangulate = GridSize{5, 5}});
  return grid ? "no error" : grid.error().message(base::MessageStyle::position);
}

TEST(Triangulate, OptionOfAFile) {
  const auto scatter = load_height_grid(SIGHTLINE_TEST_DATA "/heights/xyz-scatter.xyz", {.triangulate = GridSize{33, 17}});
  ASSERT_TRUE(scatter) << scatter.error().message();
  EXPECT_EQ(scatter->points(), 33U);
  EXPECT_EQ(scatter->slices(), 17U);
  // The least and the greatest of the first two columns of the file.
  EXPECT_EQ(scatter->domain_x, (Interval{0.047, 9.869}));
  EXPECT_EQ(scatter->domain_z, (Interval{0.075, 9.778}));
  EXPECT_GE(scatter->range.low, 0.005);
  EXPECT_LE(scatter->range.high, 2.890);
  const auto named = read_height_grid("z,y,x\n1,0,0\n2,0,4\n3,4,0\nnan,4,4\n", "points", {.triangulate = GridSize{5, 5}});
  ASSERT_TRUE(named);
  EXPECT_EQ(named->height(4, 0), 2);
  EXPECT_EQ(named->height(0, 4), 3);
  EXPECT_TRUE(std::isnan(named->height(4, 4)));
  EXPECT_EQ(named->names[2], "z");
}

TEST(Triangulate, Errors) {
  EXPECT_EQ(error_of("0 0 1\n1 1 2\n2 2 3\n3 3 4\n"), "points: found 4 points on one line, expected three points or more that are not on one line");
  EXPECT_EQ(error_of("0 0 1\n0 1 2\n0 2 3\n"), "points: found 3 points on one line, expected three points or more that are not on one line");
  EXPECT_EQ(error_of("0 0 1\n1 0 nan\n0 1 3\n"), "points: found 2 points, expected three points or more that are not on one line");
  EXPECT_EQ(error_of("0 0 1\n1 0 2\n0 1 3\n1 0 5\n"),
            "points:4:1: found a second point at x = 1, y = 0 with the height 5, expected one height for each place; the first is 2 in line 2; leave out one of them");
  EXPECT_EQ(error_of("0 0 1\n1 0 2\n0 1 3\n1 0 2\n"), "no error") << "the same point twice";
  EXPECT_EQ(error_of("1 2\n3 4\n"), "points: found 2 lines of 2 fields, expected three or more: x, y and height");
  EXPECT_EQ(error_of("0 0 1\n1e308 0 2\n-1e308 1 3\n1 5 2\n"), "no error");
}

}  // namespace
}  // namespace sightline::scene
