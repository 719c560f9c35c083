// The eye is at the origin and looks along z unless said otherwise. A corridor is 100 wide and high, with
// walls without thickness across it and a portal in each.
#include <fmt/core.h>

#include "host/report/hard_cases/jones.hpp"

namespace sightline::harness::report {

namespace {

using scene::PolyCamera;

constexpr PolyCamera backwards{true, {0, 0, 0}, {0, 0, -1}, {-1, 0, 0}, {0, 1, 0}};
constexpr PolyCamera from_the_corner{true, {0, 0, 0}, {1, 1, 1}, {1, -1, 0}, {1, 1, -2}};

std::vector<SceneSegment> nine_edges() {
  return {{{100, 0, 0}, {100, 100, 0}},     {{100, 0, 0}, {100, 0, 100}}, {{100, 100, 0}, {100, 100, 100}},
          {{100, 0, 100}, {100, 100, 100}}, {{0, 100, 0}, {100, 100, 0}}, {{0, 100, 0}, {0, 100, 100}},
          {{0, 100, 100}, {100, 100, 100}}, {{0, 0, 100}, {100, 0, 100}}, {{0, 0, 100}, {0, 100, 100}}};
}

void add_eye_cases(std::vector<JonesHardCase>& cases) {
  cases.push_back({.id = "J1",
                   .file = "J1.json",
                   .what = "edge-on portal: the plane x = 0 of a door holds the eye",
                   .expected = "the cell behind is not entered; the door's near side is seen, once",
                   .cells = 2,
                   .seen = {{{0, -5, 50}, {0, 5, 50}}},
                   .hidden = {{{50, -50, 100}, {50, 50, 100}}}});
  cases.push_back({.id = "J2",
                   .file = "J2.json",
                   .what = "eye in the plane of a portal, inside it; looking forwards and backwards",
                   .expected =
                       "native: the eye is in both cells, both half spaces are seen; program: says that it "
                       "cannot stand there",
                   .machine_rejects = true,
                   .cells = 2,
                   .seen = {},
                   .cameras = {PolyCamera{}, backwards}});
  cases.push_back({.id = "J3",
                   .file = "J3.json",
                   .what = "eye on an opaque face, x = 0, between two rooms",
                   .expected =
                       "native: the room on the side looked into is seen (straight on: the right one), and "
                       "no other; program: says that it cannot stand there",
                   .machine_rejects = true,
                   .cells = 1,
                   .seen = {{{50, -50, 100}, {50, 50, 100}}, {{50, 50, 0}, {50, 50, 100}}},
                   .hidden = {{{-50, -50, 100}, {-50, 50, 100}}, {{-50, 50, 0}, {-50, 50, 100}}}});
  cases.push_back({.id = "J4",
                   .file = "J4.json",
                   .what = "eye in a corner of its room, looking along (1, 1, 1)",
                   .expected = "native: three faces are edge-on, the other three give exactly their 9 edges; "
                               "program: says that it cannot stand there",
                   .machine_rejects = true,
                   .cells = 1,
                   .seen = nine_edges(),
                   .cameras = {from_the_corner}});
}

void add_window_cases(std::vector<JonesHardCase>& cases) {
  const SceneSegment far_corner{{50, -50, 300}, {50, 50, 300}};
  cases.push_back({.id = "J5",
                   .file = "J5.json",
                   .what = "two windows, X/S in -1/5..0 and 0..1/10, that share a side",
                   .expected = "no area in common: the third cell is not entered",
                   .cells = 2,
                   .sides = 4,
                   .hidden = {far_corner}});
  cases.push_back({.id = "J5",
                   .file = "J5-strip.json",
                   .what = "the same, the first window up to 1/100",
                   .expected = "a strip in common: the third cell is entered",
                   .cells = 3,
                   .sides = 4});
  cases.push_back({.id = "J5",
                   .file = "J5-corner.json",
                   .what = "the same, windows that share a point",
                   .expected = "no area in common: the third cell is not entered",
                   .cells = 2,
                   .sides = 4,
                   .hidden = {far_corner}});
  cases.push_back(
      {.id = "J6",
       .file = "J6.json",
       .what = "corners of a door exactly on those of the mask: (20, 20, 200) behind (10, 10, 100)",
       .expected = "the mask stays as it is, with four sides; the door's outline is kept",
       .cells = 3,
       .sides = 4,
       .seen = {{{20, -20, 200}, {20, 20, 200}}, {{-20, 20, 200}, {20, 20, 200}}}});
  cases.push_back({.id = "J6",
                   .file = "J6-outside.json",
                   .what = "a door outwards from the mask's corner, (20, 20, 200) to (45, 45, 200)",
                   .expected = "touches only: nothing of it is seen, the cell behind is not entered",
                   .cells = 2,
                   .hidden = {{{20, 20, 200}, {20, 45, 200}}, {{20, 20, 200}, {45, 20, 200}}, far_corner}});
  cases.push_back(
      {.id = "J6",
       .file = "J6-lines.json",
       .what = "lines from the mask's corner at (20, 20, 200) to (20, 45, 200) and to (5, 5, 200)",
       .expected = "the first is outside, the second inside",
       .seen = {{{20, 20, 200}, {5, 5, 200}}},
       .hidden = {{{20, 20, 200}, {20, 45, 200}}}});
  cases.push_back({.id = "J7",
                   .file = "J7.json",
                   .what = "39 portals whose left sides are on one grazing ray, x/z = 1/100",
                   .expected = "every cell is visited, and no mask has more than four sides",
                   .cells = 40,
                   .sides = 4});
}

void add_depth_cases(std::vector<JonesHardCase>& cases) {
  cases.push_back(
      {.id = "J8",
       .file = "J8.json",
       .what = "nested portals, |x|, |y| up to 20, one every 100, here 8 (see the table of first failures)",
       .expected = "every cell is visited, once; masks keep four sides",
       .cells = 9,
       .visits = 9,
       .sides = 4});
  cases.push_back(
      {.id = "J9",
       .file = "house.json",
       .what = "the house of Fig. 2: the kitchen by its door, and by the dining room and the hatch",
       .expected = "four visits of three cells, as in Fig. 5; every piece once",
       .cells = 3,
       .visits = 4});
  cases.push_back({.id = "J9",
                   .file = "J9-overlap.json",
                   .what = "bad data: two cells overlap, so that windows of one would",
                   .expected = "refused, with both cells named",
                   .rejected = true});
  cases.push_back(
      {.id = "J10",
       .file = "J10.json",
       .what = "in the image, a mask edge from (0, 0) to (131071, 1), and lines of slope 1/131070 and "
               "1/131072 behind it",
       .expected = "each pair meets in (0, 0) only: the steeper line is seen whole, the other not at all",
       .seen = {{{0, 0, 2}, {131070, 1, 2}}},
       .hidden = {{{0, 0, 2}, {131072, 1, 2}}}});
  cases.push_back(
      {.id = "J11",
       .file = "J11.json",
       .what = "a portal of 1 by 1 at z = 20000: a window of S/20000",
       .expected = "exact: not empty, the cell behind is visited; on the 340 it rounds to nothing",
       .cells = 2});
  cases.push_back({.id = "J11",
                   .file = "J11-far.json",
                   .what = "the same at z = 131071",
                   .expected = "exact: not empty, its outline is seen",
                   .seen = {{{0, 0, 131071}, {1, 0, 131071}}, {{1, 0, 131071}, {1, 1, 131071}}}});
  cases.push_back({.id = "J12",
                   .file = "J12.json",
                   .what = "z towards 0: x = 8190 at z = 1, S = 511; a quotient of 22 bits",
                   .expected = "never a wrapped number: cut, flagged or exact",
                   .cells = 2,
                   .scale = 511});
  cases.push_back({.id = "J12",
                   .file = "J12-far.json",
                   .what = "the same with x = 131071",
                   .expected = "exact algorithms are unaffected",
                   .seen = {{{-131071, 1, 1}, {131071, 1, 1}}}});
}

void add_search_cases(std::vector<JonesHardCase>& cases) {
  cases.push_back({.id = "J13",
                   .file = "J13.json",
                   .what = "a portal at x = 30 that reaches from z = -50, behind the eye, to z = 50",
                   .expected = "what is before the eye is seen through it",
                   .cells = 2,
                   .seen = {{{30, -20, 50}, {30, 20, 50}}}});
  cases.push_back({.id = "J14",
                   .file = "J14.json",
                   .what = "eye exactly in line with a wall without thickness between two doors",
                   .expected = "both rooms are seen; of the wall its near rim, as one line",
                   .cells = 3,
                   .seen = {{{0, -20, 40}, {0, 20, 40}}}});
  cases.push_back({.id = "J15",
                   .file = "J15.json",
                   .what = "cells in a circle around a pillar: the one behind it is seen from both sides",
                   .expected = "two windows of one cell: five visits of four cells, and an end",
                   .cells = 4,
                   .visits = 5});
  cases.push_back({.id = "J16",
                   .file = "J16.json",
                   .what = "a portal stands in the lists of both its cells: from behind it faces away",
                   .expected = "is not passed backwards: two visits",
                   .cells = 2,
                   .visits = 2});
  cases.push_back({.id = "J17",
                   .file = "J17.json",
                   .what = "an opening with a corner in the middle of a side",
                   .expected = "no harm: the mask has four sides",
                   .cells = 2,
                   .sides = 4});
  cases.push_back({.id = "J17",
                   .file = "J17-repeated.json",
                   .what = "an opening with a repeated corner: a side of length 0",
                   .expected = "refused, with the opening named",
                   .rejected = true});
  cases.push_back({.id = "J17",
                   .file = "J17-zero-area.json",
                   .what = "an opening without an area",
                   .expected = "refused, with the opening named",
                   .rejected = true});
}

}  // namespace

std::vector<JonesHardCase> jones_hard_cases() {
  std::vector<JonesHardCase> cases;
  add_eye_cases(cases);
  add_window_cases(cases);
  add_depth_cases(cases);
  add_search_cases(cases);
  return cases;
}

std::string expected_value(const JonesHardCase& hard) {
  if (hard.rejected) return "an error";
  std::string text = "the oracle's picture";
  if (hard.cells) text += fmt::format("; cells {}", *hard.cells);
  if (hard.visits) text += fmt::format("; visits {}", *hard.visits);
  if (hard.sides) text += fmt::format("; mask sides {}", *hard.sides);
  if (!hard.seen.empty()) text += fmt::format("; lines seen whole {}", hard.seen.size());
  if (!hard.hidden.empty()) text += fmt::format("; lines hidden whole {}", hard.hidden.size());
  return text;
}

}  // namespace sightline::harness::report
