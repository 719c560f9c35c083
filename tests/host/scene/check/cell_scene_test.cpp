// The checker: the five scenes are valid; each kind of error is named by its number.
#include "host/scene/check/cell_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "host/base/result.hpp"
#include "host/scene/model/eye_place.hpp"
#include "tests/host/scene/scene_support.hpp"

namespace sightline::scene {
namespace {

TEST(CheckScene, FindsNothingInTheBuiltinScenes) {
  for (const std::string_view name : builtin_scene_names()) {
    for (const base::Error& error : check_scene(builtin_scene(name)))
      ADD_FAILURE() << name << ": " << error.message();
  }
}

struct Change {
  const char* name;
  std::function<void(CellScene&)> apply;  // to the house
  const char* message;
};

class ImpossibleHouse : public testing::TestWithParam<Change> {};

TEST_P(ImpossibleHouse, IsNamed) {
  CellScene scene = builtin_scene("house");
  GetParam().apply(scene);
  const auto errors = check_scene(scene);
  const bool found = std::any_of(errors.begin(), errors.end(),
                                 [](const base::Error& e) { return e.message() == GetParam().message; });
  EXPECT_TRUE(found) << "expected: " << GetParam().message;
  if (!found) {
    for (const base::Error& error : errors) ADD_FAILURE() << "found: " << error.message();
  }
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, ImpossibleHouse,
    testing::Values(
        Change{"empty_cell", [](CellScene& s) { s.cells[1].box.high[1] = 0; },
               "cell 1: is empty: y 0..0, expected low < high"},
        Change{"cell_outside", [](CellScene& s) { s.cells[1].box.high[1] = 251; },
               "cell 1: reaches outside the outer box"},
        Change{"solid_outside",
               [](CellScene& s) {
                 s.solids.push_back({{-5, 0, 0}, {1, 1, 1}});
               },
               "solid 0: reaches outside the outer box"},
        Change{"wall_outside", [](CellScene& s) { s.walls[2].at = 751; },
               "wall 2: reaches outside the outer box"},
        Change{"empty_wall", [](CellScene& s) { s.walls[2].sides[0].high = 60; },
               "wall 2: is empty, expected low < high on both sides"},
        Change{"no_cells", [](CellScene& s) { s.cells.clear(); },
               "cells: expected at least one cell, found none"},
        Change{"cells_overlap", [](CellScene& s) { s.cells[1].box.high[0] = 260; },
               "cell 1: overlaps cell 2"},
        Change{"cell_overlaps_solid",
               [](CellScene& s) {
                 s.solids.push_back({{10, 10, 10}, {20, 20, 20}});
               },
               "cell 0: overlaps solid 0"},
        Change{"solids_overlap",
               [](CellScene& s) {
                 s.solids = {{{10, 10, 10}, {20, 20, 20}}, {{19, 19, 19}, {30, 30, 30}}};
               },
               "solid 0: overlaps solid 1"},
        Change{"volume", [](CellScene& s) { s.cells[1].box.high[0] = 240; },
               "volume: cells and solids together have 111625000, expected the outer box's 112500000"},
        Change{"wall_through_cell",
               [](CellScene& s) {
                 s.walls.push_back({1, 100, {geometry::Span{0, 10}, geometry::Span{0, 10}}});
               },
               "cell 0: is cut by wall 16"},
        Change{"opening_names_no_cell", [](CellScene& s) { s.openings[1].cells[1] = 3; },
               "opening 1: names cell 3, of 3"},
        Change{"opening_between_one_cell", [](CellScene& s) { s.openings[1].cells[1] = 0; },
               "opening 1: expected a rectangle with an area between two different cells"},
        Change{"opening_off_the_plane", [](CellScene& s) { s.openings[0].place.at = 399; },
               "opening 0: is not on the high z face of cell 0 (z = 400)"},
        Change{"opening_beyond_the_face", [](CellScene& s) { s.openings[0].cells[1] = 2; },
               "opening 0: is not on the low z face of cell 2 (z = 400)"},
        Change{"sides_swapped",
               [](CellScene& s) { std::swap(s.openings[2].cells[0], s.openings[2].cells[1]); },
               "opening 2: is not on the high x face of cell 2 (x = 600)"},
        Change{"ring", [](CellScene& s) { s.openings[1].ring[2][1] = 200; },
               "opening 1: the ring is not the four corners of the rectangle in order"},
        Change{"not_closed", [](CellScene& s) { s.openings[1].vectors.pop_back(); },
               "opening 1: the vectors do not close: they end at (270, 205, 400), expected (270, 0, 400)"},
        Change{"off_the_outline", [](CellScene& s) { s.openings[1].vectors[1].magnitude = 206; },
               "opening 1: vector 1 ends at (400, 206, 400), off the outline"},
        Change{"twice_round",
               [](CellScene& s) {
                 s.openings[1].vectors.push_back({true, 0, 130});
               },
               "opening 1: vector 4 ends at (400, 0, 400), off the outline"},
        Change{"magnitude", [](CellScene& s) { s.openings[1].vectors[0].magnitude = 16384; },
               "opening 1: vector 0 has magnitude 16384, expected -16384..16383 and not 0"},
        Change{"zero_vector", [](CellScene& s) { s.openings[1].vectors[0].magnitude = 0; },
               "opening 1: vector 0 has magnitude 0, expected -16384..16383 and not 0"},
        Change{"skew_line",
               [](CellScene& s) {
                 s.cells[0].lines[0].to = {600, 5, 0};
               },
               "cell 0: line 0 from (0, 0, 0) to (600, 5, 0) is not parallel to an axis"},
        Change{"line_inside_cell",
               [](CellScene& s) {
                 s.cells[0].lines[0] = {{0, 5, 5}, {600, 5, 5}};
               },
               "cell 0: line 0 from (0, 5, 5) to (600, 5, 5) is not on the cell's boundary"},
        Change{"line_beyond_cell", [](CellScene& s) { s.cells[1].lines[1].to[0] = 251; },
               "cell 1: line 1 from (0, 0, 750) to (251, 0, 750) is not on the cell's boundary"},
        Change{"wall_in_opening",
               [](CellScene& s) {
                 s.walls.push_back({2, 400, {geometry::Span{140, 160}, geometry::Span{0, 10}}});
               },
               "opening 0: is partly covered by wall 16"},
        Change{"hole_without_opening", [](CellScene& s) { s.walls.erase(s.walls.begin()); },
               "cell 0: the high z face (z = 400) is neither opaque nor open at x 0..60, y 0..205"},
        Change{"two_openings", [](CellScene& s) { s.openings.push_back(s.openings[0]); },
               "opening 0: is partly covered by opening 3"},
        Change{"view_outside",
               [](CellScene& s) {
                 s.default_view = {0, 0, -1};
               },
               "default_view: is outside the outer box"}),
    [](const auto& test) { return std::string(test.param.name); });

std::string where(const CellScene& scene, const geometry::Point& point) {
  const auto location = locate(scene, point);
  if (!location) return location.error().message();
  return std::to_string(*location);
}

TEST(Locate, FindsTheCellAroundAPoint) {
  const CellScene house = builtin_scene("house");
  EXPECT_EQ(where(house, {480, 160, 20}), "0");
  EXPECT_EQ(where(house, {100, 100, 500}), "1");
  EXPECT_EQ(where(house, {300, 100, 500}), "2");
}

TEST(Locate, OnASurfaceIsDecidedByOpeningsThenByTheViewingDirection) {
  const CellScene house = builtin_scene("house");
  EXPECT_EQ(where(house, {100, 100, 400}), "0") << "in the door between 0 and 1";
  EXPECT_EQ(where(house, {250, 100, 600}), "1") << "in the hatch between 1 and 2";
  EXPECT_EQ(where(house, {200, 100, 400}), "1") << "on the wall, looking into the kitchen";
  EXPECT_EQ(where(house, {0, 0, 0}), "0") << "a corner of the outer box";
}

TEST(Locate, RejectsSolidsAndTheOutside) {
  const CellScene roberts = builtin_scene("roberts");
  EXPECT_EQ(where(roberts, {0, -50, 700}), "point (0, -50, 700): is inside solid 0");
  EXPECT_EQ(where(roberts, {0, 0, 9}), "point (0, 0, 9): is outside the outer box");
}

}  // namespace
}  // namespace sightline::scene
