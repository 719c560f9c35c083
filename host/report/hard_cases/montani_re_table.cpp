// The view is along z, x to the right, y up; what has the smaller z is nearer.
#include "host/report/hard_cases/montani_re.hpp"

namespace sightline::harness::report {

namespace {

using Combination = LatticeExpected::Combination;

void add_cycles(std::vector<MontaniReHardCase>& cases) {
  cases.push_back({.id = "M1",
                   .file = "M1.json",
                   .what = "cycle of three: planes z = x, z = y, z = 40 - x - y",
                   .expected = "no face that none hides; one subtraction solves it",
                   .areas = {200, 200, 400},
                   .cuts = 1,
                   .parts = 0});
  cases.push_back({.id = "M1'",
                   .file = "M1-four.json",
                   .what = "pinwheel of four bars",
                   .expected = "cycle of four; one subtraction solves it",
                   .areas = {200, 200, 200, 200},
                   .cuts = 1,
                   .parts = 0});
  cases.push_back({.id = "M2",
                   .file = "M2.json",
                   .what = "M1 three times: two beside each other, one far behind the first",
                   .expected = "a subtraction a cycle; nothing is seen of the third",
                   .areas = {200, 200, 400, 200, 200, 400, 0, 0, 0},
                   .cuts = 3});
  cases.push_back({.id = "M2",
                   .file = "M2-shared.json",
                   .what = "M1 twice, both with the same bar z = x",
                   .expected = "two cycles that share a face: a subtraction for each",
                   .areas = {700, 200, 400, 200, 400},
                   .cuts = 2,
                   .parts = 0});
  cases.push_back({.id = "M3",
                   .file = "M3.json",
                   .what = "Figure 10: a strip z = x - 5 through a U at z = 10",
                   .expected =
                       "each hides the other in one place, which the paper gives up: no relation, a part "
                       "cut off each",
                   .areas = {600, 300},
                   .relations = 0,
                   .parts = 2});
  cases.push_back({.id = "M3",
                   .file = "M3-portal.json",
                   .what = "Figure 10: a bar z = x - 4 and a portal at z = 0",
                   .expected = "as M3; one point of the common region would decide both places",
                   .areas = {42, 24},
                   .relations = 0,
                   .parts = 2});
  cases.push_back({.id = "M4",
                   .file = "M4.json",
                   .what = "z = x and z = 20 - x over the same square",
                   .expected = "faces that pass through each other have no order: refused by name",
                   .areas = {100, 200, 200},
                   .through = {{1, 2}}});
}

void add_planes(std::vector<MontaniReHardCase>& cases) {
  cases.push_back({.id = "M5",
                   .file = "M5.json",
                   .what = "coplanar squares that overlap",
                   .expected = "no relation; in one silhouette the common area counts once, for the first",
                   .areas = {100, 75},
                   .relations = 0,
                   .whole_silhouette = true});
  cases.push_back(
      {.id = "M6",
       .file = "M6.json",
       .what = "coplanar squares with a common side, one class",
       .expected = "drawn one by one: the common side, which \"all faces of a class at once\" loses, stays",
       .areas = {100, 100},
       .relations = 0,
       .whole_silhouette = true});
  cases.push_back({.id = "M7",
                   .file = "M7.txt",
                   .what = "squares of 100, 80, 60, 40, 20 in each other, one region",
                   .expected = "holes in holes: 10000 - 6400 + 3600 - 1600 + 400",
                   .regions = {{Combination::first, 8 * 6000, 5}}});
  cases.push_back(
      {.id = "M8",
       .file = "M8.txt",
       .what = "diamonds cut out of a square of 20: one corner touches the outline, one the other hole",
       .expected =
           "substripes meet in a point; no piece without width; one loop, that turns left where it meets "
           "itself",
       .regions = {{Combination::less, 8 * (400 - 64), 1}}});
  cases.push_back({.id = "M8",
                   .file = "M8-pair.txt",
                   .what = "two diamonds that touch in a point",
                   .expected = "two loops, not one of figure eight",
                   .regions = {{Combination::either, 8 * 16, 2}}});
  cases.push_back(
      {.id = "M9",
       .file = "M9.json",
       .what = "a triangle 1000 long and 1 high",
       .expected = "exact; stripes thicker than it lose it, which the table of first failures shows",
       .areas = {500, 19500}});
}

void add_joins(std::vector<MontaniReHardCase>& cases) {
  cases.push_back({.id = "M10",
                   .file = "M10.json",
                   .what = "corners on lines between stripes, horizontal edges there",
                   .expected = "stripes of every thickness up to 8 are exact",
                   .areas = {288, 480, 768},
                   .on_lines = true});
  cases.push_back({.id = "M10",
                   .file = "M10.txt",
                   .what = "two rectangles, one on the other",
                   .expected = "united, there is no edge between them",
                   .regions = {{Combination::either, 8 * 100, 1}}});
  cases.push_back({.id = "M11",
                   .file = "M11.txt",
                   .what = "/ from x = 0 and \\ from x = 1 cross in the middle of a square",
                   .expected = "areas in quarters of a square, which only the doubled lattice has",
                   .regions = {{Combination::first, 4, 1},
                               {Combination::both, 2, 1},
                               {Combination::either, 6, 1},
                               {Combination::less, 2, 1}}});
  cases.push_back({.id = "M12",
                   .file = "M12.txt",
                   .what = "/ from x = 0 and \\ from x = 2 meet at the end of their stripe",
                   .expected = "one triangular substripe",
                   .regions = {{Combination::first, 8, 1}}});
  cases.push_back({.id = "M13",
                   .file = "M13.json",
                   .what = "extents in X touch at x = 10",
                   .expected = "no relation",
                   .areas = {100, 100},
                   .relations = 0});
  cases.push_back({.id = "M14",
                   .file = "M14.json",
                   .what = "extents in Z touch: a ramp from z = 0 backwards behind a square at z = 0",
                   .expected = "test 3, mended and strict, leaves it to the planes: one relation",
                   .areas = {100, 50},
                   .relations = 1,
                   .by_test_3 = 0});
}

void add_tables(std::vector<MontaniReHardCase>& cases) {
  cases.push_back({.id = "M15",
                   .file = "M15.json",
                   .what = "a wide face, given last, before all others",
                   .expected = "test 1 may end the inner loop because faces are sorted on lowest X",
                   .areas = {0, 0, 0, 2000},
                   .relations = 3});
  cases.push_back({.id = "M16",
                   .file = "M16.json",
                   .what = "a face seen edge-on before another",
                   .expected = "left out: no relation, no division by the normal's z",
                   .areas = {0, 100},
                   .relations = 0,
                   .edge_on = 1});
  cases.push_back(
      {.id = "M17",
       .file = "M17.json",
       .what = "seven rectangles in a row with the relations of Table 3 (Figure 4 is not legible)",
       .expected = "the priority list of Table 4",
       .areas = {100, 80, 80, 60, 80, 80, 100},
       .relations = 6,
       .list = "S,E / U,C / R,A / F"});
  cases.push_back({.id = "M18",
                   .file = "M18.txt",
                   .what = "chains that give Table 1 (Figure 1 is not legible)",
                   .expected = "areas 22 and 27 - 5; the stripes of Table 1, entry by entry, in part 1",
                   .regions = {{Combination::first, 8 * 22, 1}, {Combination::either, 8 * 44, 3}}});
}

}  // namespace

std::vector<MontaniReHardCase> montani_re_hard_cases() {
  std::vector<MontaniReHardCase> cases;
  add_cycles(cases);
  add_planes(cases);
  add_joins(cases);
  add_tables(cases);
  return cases;
}

}  // namespace sightline::harness::report
