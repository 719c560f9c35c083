// Jones's program on the PDP-7 and Skala's on the 8080 in the cross-check: the bound of their distance from exact lines, computed
// by
// hand, and the detection of a displaced line.
#include "host/compare/cross_check_machines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "host/algorithms/registry/lines.hpp"

namespace sightline::compare {
namespace {

// An empty room. From its middle the edges between front and back wall run to (5, 3) and so on, and leave the window at its
// sides.
scene::CellScene room() {
  scene::CellScene scene;
  scene.name = "room";
  scene.outer = {{-100, -60, 0}, {100, 60, 400}};
  scene.default_view = {0, 0, 200};
  scene::Cell cell{scene.outer, {}};
  for (const std::int32_t x : {-100, 100})
    for (const std::int32_t y : {-60, 60}) cell.lines.push_back({{x, y, 0}, {x, y, 400}});
  scene.cells.push_back(cell);
  return scene;
}

// Both projected coordinates of such an edge are up to half a unit off: perpendicular to it (5 + 3) / 2 in units of 1 / sqrt(34).
// At the
// side of the window y is rounded again: 5/2 more. Along the edge the cut is off by 4 * 3/5, where the displaced edge meets the
// side,
// and by 3/2 from rounding. Together sqrt(6.5^2 + 3.9^2) / sqrt(34) = 1.3.
TEST(JonesBound, OfAnEdgeCutByTheWindowAsByHand) {
  const scene::CellScene scene = room();
  for (const int bits : {0, 1, 3, 8})
    EXPECT_NEAR(jones_piece_bound(scene, scene.default_view, {24, bits}), std::ldexp(1.3, -bits), 1e-9) << bits;
}

TEST(JonesBound, OfLinesBetweenPointsIsHalfAPointMoreEachWay) {
  EXPECT_EQ(jones_line_bound(0.25, {18, 0}), 0.25);
  EXPECT_DOUBLE_EQ(jones_line_bound(0.25, {18, 2}), 0.25 + std::sqrt(0.5));
}

// From the middle of every cell of a house and of a corridor, and from a point next to it.
TEST(JonesBound, HoldsFromEveryCell) {
  std::size_t views = 0;
  for (const std::string_view name : {"J1", "J4"}) {
    const CommonScene scene = common_scene(name);
    const auto exact = registry::find_line_algorithm("exact")->prepare(scene.scene);
    CrossCheckView view = scene.views.front();
    for (const scene::Cell& cell : scene.cells->cells) {
      for (const std::int32_t part : {3, 2}) {
        for (std::size_t a = 0; a < 3; ++a) view.camera.eye[a] = cell.box.low[a] + (cell.box.high[a] - cell.box.low[a]) / part;
        const auto builds = jones_twins(scene, view);
        if (!builds) continue;
        ++views;
        const auto seen = registry::view_of(*exact, view.camera, scene.matter->lines_at(view.camera.eye));
        const ViewVerdict verdict =
            compare_pictures(scene, view, NamedJones{"jones-twin", &*builds}, NamedLines{"exact", &seen->picture, true});
        EXPECT_TRUE(verdict.agrees) << name << " from " << view.camera.eye[0] << ", " << view.camera.eye[1] << ", "
                                    << view.camera.eye[2] << ": " << verdict.text;
      }
    }
  }
  EXPECT_GE(views, 20U);
}

// From three cells, for the machine's own words: the bound holds and is tight, because some line is farther off than half of it.
TEST(JonesBound, HoldsForTheMachinesWordsAndIsNear) {
  for (const std::string_view name : {"J1", "J4"}) {
    const CommonScene scene = common_scene(name);
    const auto exact = registry::find_line_algorithm("exact")->prepare(scene.scene);
    CrossCheckView view = scene.views.front();
    std::size_t eyes = 0;
    double nearest = 0;  // as a fraction of the bound
    for (const scene::Cell& cell : scene.cells->cells) {
      if (eyes == 3) break;
      for (std::size_t a = 0; a < 3; ++a) view.camera.eye[a] = cell.box.low[a] + (cell.box.high[a] - cell.box.low[a]) / 3;
      const auto builds = jones_on_pdp7(scene, view, true);
      if (!builds) continue;
      ++eyes;
      const auto seen = registry::view_of(*exact, view.camera, scene.matter->lines_at(view.camera.eye));
      const ViewVerdict verdict =
          compare_pictures(scene, view, NamedJones{jones_pdp7_name, &*builds}, NamedLines{"exact", &seen->picture, true});
      EXPECT_TRUE(verdict.agrees) << name << ": " << verdict.text;
      for (const auto& distance : verdict.distances) nearest = std::max(nearest, distance.found / distance.bound);
    }
    EXPECT_EQ(eyes, 3U) << name;
    EXPECT_GT(nearest, 0.5) << name;
  }
}

picture::PixelSegment move_across(const picture::PixelSegment& line, double by) {
  const double length = std::hypot(line.b.x - line.a.x, line.b.y - line.a.y);
  const picture::PixelPoint across{(line.a.y - line.b.y) / length * by, (line.b.x - line.a.x) / length * by};
  return {{line.a.x + across.x, line.a.y + across.y}, {line.b.x + across.x, line.b.y + across.y}};
}

TEST(MachinePictures, ALineOfJonesMovedByTwoPointsIsFound) {
  const CommonScene scene = common_scene("J3");
  const CrossCheckView& view = scene.views.front();
  auto builds = *jones_on_pdp7(scene, view, true);
  const auto exact = registry::find_line_algorithm("exact")->prepare(scene.scene);
  const auto seen = registry::view_of(*exact, view.camera, scene.matter->lines_at(view.camera.eye));
  const NamedLines lines{"exact", &seen->picture, true};
  ASSERT_TRUE(compare_pictures(scene, view, NamedJones{"jones-pdp7", &builds}, lines).agrees);
  auto longest = std::max_element(builds[3].lines.begin(), builds[3].lines.end(), [](const auto& a, const auto& b) {
    return std::hypot(a.b.x - a.a.x, a.b.y - a.a.y) < std::hypot(b.b.x - b.a.x, b.b.y - b.a.y);
  });
  *longest = move_across(*longest, 2);
  EXPECT_FALSE(compare_pictures(scene, view, NamedJones{"jones-pdp7", &builds}, lines).agrees);
}

TEST(MachinePictures, OtherDisplayWordsAreFound) {
  const CommonScene scene = common_scene("J1");
  const auto machine = *jones_on_pdp7(scene, scene.views.front(), true);
  auto twins = *jones_twins(scene, scene.views.front());
  ASSERT_TRUE(compare_pictures(NamedJones{"jones-pdp7", &machine}, NamedJones{"jones-twin", &twins}).agrees);
  twins[1].display_file[5] = twins[1].display_file[5] ^ core::Word18(1);
  const ViewVerdict verdict = compare_pictures(NamedJones{"jones-pdp7", &machine}, NamedJones{"jones-twin", &twins});
  EXPECT_FALSE(verdict.agrees);
  EXPECT_TRUE(verdict.text.starts_with("1 fraction bits")) << verdict.text;
}

TEST(MachinePictures, AnExtraDotAndAMovedLineOfAPlotterAreFound) {
  const CommonScene scene = common_scene("H1");
  const auto pictures = skala_pictures(*scene.heights, program_view(scene));
  std::vector<SkalaInk> dot_more{pictures[0]};
  ASSERT_TRUE(compare_with_oracle(scene, {skala_8080_name, &dot_more}).agrees);
  dot_more[0].dots.set(3, 250, 1);
  EXPECT_FALSE(compare_with_oracle(scene, {skala_8080_name, &dot_more}).agrees);
  for (const SkalaInk& picture : pictures) {
    if (picture.device != programs::skala::Device::calcomp) continue;
    std::vector<SkalaInk> aside{picture};
    // The leftmost ink is the corner of the domain, with nothing next to it.
    auto& ink = aside[0].ink;
    const auto leftmost = std::min_element(
        ink.begin(), ink.end(), [](const auto& a, const auto& b) { return std::min(a.a.x, a.b.x) < std::min(b.a.x, b.b.x); });
    for (picture::PixelPoint* end : {&leftmost->a, &leftmost->b}) end->x -= 2.5;
    EXPECT_FALSE(compare_with_oracle(scene, {skala_8080_name, &aside}).agrees) << name_of(picture);
  }
}

}  // namespace
}  // namespace sightline::compare
