// The comparison of all methods: openness computed by hand, and the position of a crossing.
#include "host/report/experiments/comparison.hpp"

#include <gtest/gtest.h>

#include <string>

#include "host/scene/generate/open_rooms.hpp"
#include "host/scene/read/cell_scene.hpp"

namespace sightline::report {
namespace {

scene::CellScene built_in(const std::string& name) {
  auto scene = scene::load_cell_scene(name);
  EXPECT_TRUE(scene.has_value());
  return *std::move(scene);
}

// Cells of 2 x 2 rooms touch along four sides; those at a corner share only a line. A corridor of 8 rooms has 7 walls with a door
// each.
TEST(Comparison, WallsAreCountedByHand) {
  EXPECT_EQ(walls_of(scene::generate_open_rooms(2, 5)), 4U);
  EXPECT_EQ(walls_of(scene::generate_open_rooms(2, 0)), 4U);
  EXPECT_EQ(walls_of(built_in("corridor8")), 7U);
  EXPECT_EQ(built_in("corridor8").openings.size(), 7U);
  ComparisonScene scene;
  EXPECT_FALSE(scene.openness());
  scene.portals = 5;
  scene.walls = 4;
  EXPECT_EQ(scene.openness(), 1.25);
}

TEST(Comparison, ACrossingIsWhereTheFirstIsNoLongerSmaller) {
  const Crossing crossing = crossing_of({{1, 10, 20}, {2, 15, 20}, {3, 25, 20}, {4, 10, 20}});
  EXPECT_EQ(crossing.last, 2);
  EXPECT_EQ(crossing.first, 3);
  EXPECT_FALSE(crossing_of({{1, 20, 20}, {2, 10, 20}}).last) << "never smaller";
  EXPECT_FALSE(crossing_of({{1, 10, 20}, {2, 10, 20}}).first) << "smaller to the end";
}

}  // namespace
}  // namespace sightline::report
