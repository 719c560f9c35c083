#include <cstdint>

#include "host/report/hard_cases/skala.hpp"
#include "host/report/hard_cases/skala_checks.hpp"

namespace sightline::harness::report {

namespace {

using algorithms::oracle::Chain;
using algorithms::oracle::SegmentRole;

guests::skala::View lines(guests::skala::Family family, double rotation, double elevation) {
  guests::skala::View view;
  view.family = family;
  view.rotation = rotation;
  view.elevation = elevation;
  return view;
}

// A chain of points at one depth, drawn from the first to the last; a gap before each point that says so.
struct ChainPoint {
  int x = 0;
  int y = 0;
  bool gap = false;
};

Chain chain(int depth, const std::vector<ChainPoint>& points) {
  Chain made{depth, {}};
  for (const ChainPoint& point : points) {
    const bool begins = made.vertices.empty() || point.gap;
    made.vertices.push_back(
        {point.x, point.y, std::int64_t{depth} * 1000, begins ? SegmentRole::none : SegmentRole::draw});
  }
  return made;
}

void add_first_cases(std::vector<SkalaHardCase>& cases) {
  cases.push_back({.id = "S1",
                   .file = "S1.csv",
                   .what = "the first slice, before any mask is set",
                   .expected = "wholly visible",
                   .value = "every dot of the first slice; one line of 5 points",
                   .view = lines(guests::skala::Family::along_x, 0, 30),
                   .dots = near_slice_lit,
                   .lines = first_line_whole});
  cases.push_back({.id = "S2",
                   .file = "S2.csv",
                   .what = "a flat surface seen edge-on",
                   .expected = "slices after the first lie on the mask: drawn once",
                   .value = "256 dots, one row; ink of one row",
                   .view = lines(guests::skala::Family::along_x, 0, 0),
                   .dots = one_row,
                   .lines = ink_of_one_row});
  cases.push_back({.id = "S3",
                   .file = "S3.csv",
                   .what = "six equal slices, seen without elevation",
                   .expected = "what equals the horizon is not drawn again",
                   .value = "the dots of the first slice and no other; one line of 7 points",
                   .view = lines(guests::skala::Family::along_x, 0, 0),
                   .dots = near_slice_only,
                   .lines = one_line});
  cases.push_back({.id = "S4",
                   .file = "S4.txt",
                   .what = "a near-vertical step, (10, 0) to (11, 200)",
                   .expected = "a column does not hide itself",
                   .value = "201 dots",
                   .chains = {chain(0, {{10, 0}, {11, 200}})},
                   .lit = 201});
  cases.push_back({.id = "S4",
                   .file = "S4.dat",
                   .what = "a cliff in 1/100 of the width",
                   .expected = "the first slice is wholly visible",
                   .value = "every dot of the first slice; one line of 5 points",
                   .view = lines(guests::skala::Family::along_x, 0, 30),
                   .dots = near_slice_lit,
                   .lines = first_line_whole});
  cases.push_back({.id = "S5",
                   .file = "S5.txt",
                   .what = "an exactly vertical line",
                   .expected = "200 steps, no division by its width",
                   .value = "201 dots",
                   .chains = {chain(0, {{10, 0}, {10, 200}})},
                   .lit = 201});
  cases.push_back({.id = "S5",
                   .file = "S5.csv",
                   .what = "four slices seen end-on",
                   .expected = "four upright lines",
                   .value = "every dot of every slice; 4 lines",
                   .view = lines(guests::skala::Family::along_x, 90, 30),
                   .dots = every_slice_lit,
                   .lines = line_a_slice});
  cases.push_back({.id = "S6",
                   .file = "S6.txt",
                   .what = "a line of no length, (10, 10) to (10, 10)",
                   .expected = "no step, but its first point is drawn",
                   .value = "1 dot",
                   .chains = {chain(0, {{10, 10}, {10, 10}})},
                   .lit = 1});
}

void add_order_cases(std::vector<SkalaHardCase>& cases) {
  cases.push_back(
      {.id = "S7",
       .file = "",
       .what = "all lines from (x, y) to (x + u, y + v), u and v from -16 to 16, and back, 49 a screen "
               "without visibility test, at x, y = 18 + 36 n, n = 0 to 6, x first",
       .expected = "rounded as rational numbers are; the same dots from either end",
       .value = "the dots of 1089 lines"});
  cases.push_back({.id = "S8",
                   .file = "S8.dat",
                   .what = "slices in the file from far to near, turned by 30 degrees",
                   .expected = "order is by depth, not by the file: the right picture",
                   .value = "the oracle's picture, made of depths alone",
                   .view = lines(guests::skala::Family::along_x, 30, 30)});
  cases.push_back({.id = "S8",
                   .file = "S8-backwards.txt",
                   .what = "commands sent from the background to the foreground",
                   .expected = "front to back is a precondition: the program cannot know, and draws too much",
                   .value = "the picture in the right order",
                   .chains = {chain(0, {{0, 0}, {255, 0}}), chain(1, {{0, 50}, {128, 200}, {255, 50}}),
                              chain(2, {{0, 100}, {255, 100}})}});
  cases.push_back({.id = "S9",
                   .file = "S9.csv",
                   .what = "two families of slices, a flat net seen from above",
                   .expected = "no line of either is lost",
                   .value = "every dot of the net; 3 and 4 lines",
                   .view = lines(guests::skala::Family::both, 0, 40),
                   .dots = whole_net_lit,
                   .lines = line_a_slice_and_point});
  cases.push_back({.id = "S9",
                   .file = "S9-hills.csv",
                   .what = "two families of slices, hills turned by 30 degrees",
                   .expected = "hidden cell by cell from front to back",
                   .value = "the oracle's picture, made of depths alone",
                   .view = lines(guests::skala::Family::both, 30, 30)});
  cases.push_back({.id = "S10",
                   .file = "S10.txt",
                   .what = "two islands in one slice, and a farther line at their height",
                   .expected = "there is no strip between the islands: the line is seen there",
                   .value = "256 dots",
                   .chains = {chain(0, {{20, 100}, {60, 100}, {190, 100, true}, {230, 100}}),
                              chain(1, {{0, 100}, {255, 100}})},
                   .lit = 256});
  cases.push_back({.id = "S10",
                   .file = "S10.csv",
                   .what = "a slice with undefined heights between two islands, and a farther slice",
                   .expected = "the farther slice is seen through the gap",
                   .value = "its dots from column 100 to 155; a line across the gap",
                   .view = lines(guests::skala::Family::along_x, 0, 5),
                   .dots = far_slice_in_gap,
                   .lines = line_through_gap});
}

void add_raster_cases(std::vector<SkalaHardCase>& cases) {
  cases.push_back(
      {.id = "S11",
       .file = "S11.csv",
       .what = "lines of slopes 1/255 and 4.5/255 that cross",
       .expected = "the crossing is off by no more than 1 / (difference of slopes) columns (see the table "
                   "of first failures)",
       .value = "the oracle's picture",
       .view = lines(guests::skala::Family::along_x, 0, 0)});
  cases.push_back({.id = "S12",
                   .file = "S12.csv",
                   .what = "a spike in one sample",
                   .expected = "drawn as the triangle it is in linear interpolation",
                   .value = "the oracle's picture; every dot of the first slice",
                   .view = lines(guests::skala::Family::along_x, 0, 30),
                   .dots = near_slice_lit});
  cases.push_back({.id = "S13",
                   .file = "S13.txt",
                   .what = "lines along all four borders of the screen",
                   .expected = "drawn; no array is left",
                   .value = "1020 dots",
                   .chains = {chain(0, {{0, 0}, {0, 255}}), chain(1, {{255, 0}, {255, 255}}),
                              chain(2, {{0, 0}, {255, 0}}), chain(3, {{0, 255}, {255, 255}})},
                   .lit = 1020});
  cases.push_back({.id = "S14",
                   .file = "S14.txt",
                   .what = "lines across all 256 columns, by 1 and by 127 rows",
                   .expected = "twice the width does not fit a byte: the error term must not need it",
                   .value = "512 dots",
                   .chains = {chain(0, {{0, 10}, {255, 11}}), chain(1, {{0, 20}, {255, 147}})},
                   .lit = 512});
  cases.push_back({.id = "S14",
                   .file = "S14.csv",
                   .what = "hills; native masks of 16384 columns",
                   .expected = "the same picture, finer",
                   .value = "the oracle's picture; the first slice whole",
                   .view = lines(guests::skala::Family::along_x, 0, 30),
                   .lines = first_line_whole,
                   .columns = algorithms::skala::most_columns});
}

void add_surface_cases(std::vector<SkalaHardCase>& cases) {
  guests::skala::View zoomed = lines(guests::skala::Family::along_x, 0, 30);
  zoomed.zoom = 3;
  cases.push_back({.id = "S13",
                   .file = "S13.csv",
                   .what = "a picture three times as large as the screen",
                   .expected = "cut at the borders without moving a dot",
                   .value = "those dots of the first slice that are on the screen",
                   .view = zoomed,
                   .dots = near_slice_lit});
  cases.push_back({.id = "S15",
                   .file = "S15.csv",
                   .what = "a pit whose bottom hangs below the near edge",
                   .expected = "the underside is seen by the bottom masks",
                   .value = "the oracle's picture; ink in the bottom row",
                   .view = lines(guests::skala::Family::along_x, 0, 10),
                   .dots = bottom_lit,
                   .lines = reaches_bottom});
  cases.push_back({.id = "S15",
                   .file = "S9-hills.csv",
                   .what = "hills seen from below, by -30 degrees",
                   .expected = "both horizons are independent",
                   .value = "the oracle's picture",
                   .view = lines(guests::skala::Family::along_x, 0, -30)});
  guests::skala::View contours = lines(guests::skala::Family::automatic, 0, 60);
  contours.picture = guests::skala::PictureKind::contours;
  contours.levels = 3;
  cases.push_back({.id = "S16",
                   .file = "S16.csv",
                   .what = "contours, one level exactly through a row of vertices",
                   .expected = "each segment once",
                   .value = "the oracle's picture; one line a level",
                   .view = contours,
                   .lines = line_a_level});
}

}  // namespace

std::vector<SkalaHardCase> skala_hard_cases() {
  std::vector<SkalaHardCase> cases;
  add_first_cases(cases);
  add_order_cases(cases);
  add_raster_cases(cases);
  add_surface_cases(cases);
  return cases;
}

}  // namespace sightline::harness::report
