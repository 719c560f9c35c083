// The lines derived from boxes and walls, compared with counts and drawings from other programs.
#include "host/algorithms/oracle/matter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "host/geometry/interval_set.hpp"
#include "tests/host/scene/scene_support.hpp"

namespace sightline::algorithms::oracle {
namespace {

using geometry::Box;
using geometry::IntervalSet;
using geometry::Point;
using geometry::Rectangle;
using geometry::Span;

// The table of scenes in the specification.
TEST(RealLines, AreAsManyAsSpecified) {
  const std::map<std::string_view, std::size_t> expected{
      {"house", 32}, {"roberts", 45}, {"street4", 132}, {"corridor8", 68}, {"corridor32", 260}};
  for (const auto& [name, count] : expected) {
    EXPECT_EQ(Matter::of(scene::builtin_scene(name)).value().real_lines().size(), count) << name;
  }
}

// A line of space (axis and the two other coordinates) and its drawn stretches.
using Drawing = std::map<std::array<std::int32_t, 3>, IntervalSet>;

void draw(Drawing& drawing, const Point& a, const Point& b) {
  std::size_t axis = 0;
  while (a[axis] == b[axis]) ++axis;
  const auto [u, v] = geometry::other_axes(axis);
  drawing[{static_cast<std::int32_t>(axis), a[u], a[v]}].unite(std::min(a[axis], b[axis]),
                                                               std::max(a[axis], b[axis]));
}

// Another program made the cell lines and real ring vectors from the cells.
TEST(RealLines, AreTheCellLinesAndOpeningOutlinesOfTheScene) {
  for (const std::string_view name : scene::builtin_scene_names()) {
    const scene::CellScene scene = scene::builtin_scene(name);
    Drawing derived;
    Drawing given;
    for (const RealLine& line : Matter::of(scene).value().real_lines()) draw(derived, line.from, line.to);
    for (const scene::Cell& cell : scene.cells) {
      for (const scene::Line& line : cell.lines) draw(given, line.from, line.to);
    }
    for (const scene::Opening& opening : scene.openings) {
      Point pen = opening.ring[0];
      for (const scene::RingVector& vector : opening.vectors) {
        const Point from = pen;
        pen[vector.axis] += vector.magnitude;
        if (vector.actual) draw(given, from, pen);
      }
    }
    EXPECT_EQ(derived, given) << name;
  }
}

// "Gap 3": the partition x = 250 of the house meets the wall z = 400 from behind: a corner on that side, flat on the front.
TEST(RealLines, AreFeaturesOnOneSideOnlyWhereAPartitionMeetsAWall) {
  const auto lines = Matter::of(scene::builtin_scene("house")).value().real_lines();
  const auto corner = std::find_if(lines.begin(), lines.end(), [](const RealLine& line) {
    return line.axis == 1 && line.from == Point{250, 0, 400};
  });
  ASSERT_NE(corner, lines.end());
  EXPECT_EQ(corner->to, (Point{250, 250, 400}));
  EXPECT_EQ(corner->feature, (std::array<bool, 4>{false, false, true, true}));  // quadrants with z > 400
}

scene::CellScene room(std::vector<Box> solids, std::vector<Rectangle> walls) {
  scene::CellScene scene;
  scene.outer = {{0, 0, 0}, {100, 100, 100}};
  scene.solids = std::move(solids);
  scene.walls = std::move(walls);
  return scene;
}

TEST(RealLines, OfAnEmptyRoomAndOfTouchingBoxes) {
  EXPECT_EQ(Matter::of(room({}, {})).value().real_lines().size(), 12U);
  EXPECT_EQ(Matter::of(room({{{20, 20, 20}, {40, 40, 40}}}, {})).value().real_lines().size(), 24U);
  // Two boxes make one: no lines at the joint.
  EXPECT_EQ(Matter::of(room({{{20, 20, 20}, {30, 40, 40}}, {{30, 20, 20}, {40, 40, 40}}}, {}))
                .value()
                .real_lines()
                .size(),
            24U);
  // Two pieces of one sheet: only its boundary.
  EXPECT_EQ(
      Matter::of(room({}, {{2, 50, {Span{20, 30}, Span{20, 40}}}, {2, 50, {Span{30, 40}, Span{20, 40}}}}))
          .value()
          .real_lines()
          .size(),
      16U);
}

TEST(Matter, RejectsEmptyAndTooLargeScenes) {
  EXPECT_FALSE(Matter::of(scene::CellScene{}));
  EXPECT_FALSE(Matter::of(room({{{20, 20, 20}, {20, 40, 40}}}, {})));
  std::vector<Box> many;
  for (std::int32_t i = 0; i < 300; ++i)
    many.push_back({{2 * i, 2 * i, 2 * i}, {2 * i + 1, 2 * i + 1, 2 * i + 1}});
  auto scene = room(std::move(many), {});
  scene.outer.high = {1000, 1000, 1000};
  EXPECT_FALSE(Matter::of(scene));
}

}  // namespace
}  // namespace sightline::algorithms::oracle
