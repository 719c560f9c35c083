// Plans are (x, z), the eye at height 0 looks along z unless said otherwise.
#include <algorithm>

#include "host/report/hard_cases/willis.hpp"
#include "host/report/hard_cases/willis_facts.hpp"

namespace sightline::harness::report {

namespace {

namespace willis = algorithms::willis;
using willis::BoundaryShape;

constexpr std::string_view the_picture = "the picture of the nearest faces";

void add_boundary_cases(std::vector<WillisHardCase>& cases) {
  cases.push_back({.id = "W1",
                   .file = "W1.json",
                   .what = "a wall exactly at another one's length: (0, 0)-(10, 0) and (0, 10)-(5, 10)",
                   .expected = "on the boundary is inside: a cluster, cut until there is none",
                   .checked = "in the boundary, by both shapes; 2 clusters",
                   .facts = willis_facts::at_the_length,
                   .clusters = 2});
  cases.push_back({.id = "W1",
                   .file = "W1-apart.json",
                   .what = "the same, one unit farther",
                   .expected = "no cluster, nothing is cut",
                   .checked = "not in the boundary, by both shapes; no cluster",
                   .facts = willis_facts::beyond_the_length,
                   .clusters = 0});
  cases.push_back({.id = "W2",
                   .file = "W2.json",
                   .what = "a short wall in the boundary of a long one, not the long one in its",
                   .expected = "either is enough: a cluster",
                   .checked = "one reaches into the boundary of the other, not the other way; 2 clusters",
                   .facts = willis_facts::one_way,
                   .clusters = 2});
  cases.push_back({.id = "W3",
                   .file = "W3.json",
                   .what = "a chain of three walls of 10, 9 apart",
                   .expected = "neighbours are clusters, the first and the third are not",
                   .checked = "the three pairs, by both shapes; 4 clusters",
                   .facts = willis_facts::chain,
                   .clusters = 4});
  cases.push_back(
      {.id = "W4",
       .file = "W4.json",
       .what = "beside the middle of a wall of 2 one of 0.001 at 1.9 (in units of 1/10000); ovals",
       .expected = "1.9 from the wall: in the oval, a cluster; the picture is right",
       .checked = "in the oval only; areas 0.98312 to 1; 2 clusters",
       .facts = willis_facts::oval_only,
       .options = {.rules = {BoundaryShape::oval, false}, .plan = true},
       .clusters = 2});
  cases.push_back({.id = "W4",
                   .file = "W4.json",
                   .what = "the same by two circles",
                   .expected = "2.147 from both ends: in neither circle, no cluster; the picture is right",
                   .checked = "in the oval only; no cluster",
                   .facts = willis_facts::oval_only,
                   .clusters = 0});
  cases.push_back({.id = "W5",
                   .file = "W5.json",
                   .what = "a wall in two halves: what their ovals cover",
                   .expected = "(1 + pi/4) to (pi + 2), 65.3 % less",
                   .checked = "areas, by counting points of a fine lattice, within 0.2 %",
                   .facts = willis_facts::areas,
                   .clusters = 0});
}

void add_touching_cases(std::vector<WillisHardCase>& cases) {
  cases.push_back({.id = "W6",
                   .file = "W6.json",
                   .what = "walls of different solids that touch, distance alone",
                   .expected = "no number of cuts can separate them: an end, and the pair is named",
                   .checked = "pieces at most 64; the pair is named, with the reason",
                   .facts = willis_facts::few_pieces,
                   .end = WillisEnd::left_over,
                   .options = {.order_cells = false, .plan = true}});
  cases.push_back({.id = "W6",
                   .file = "W6.json",
                   .what = "the same with order cells",
                   .expected = "solved: the side of the eye decides",
                   .checked = the_picture});
  cases.push_back({.id = "W7",
                   .file = "W7.json",
                   .what = "two cubes that share a face",
                   .expected = "the common faces need no order; the cubes are told apart by an order cell",
                   .checked = "neither face in the common plane can hide the other",
                   .facts = willis_facts::common_plane,
                   .options = {}});
  cases.push_back({.id = "W7",
                   .file = "W7.json",
                   .what = "the same with the 90-degree rule",
                   .expected = "the same: nothing here depends on the rule",
                   .checked = the_picture,
                   .options = {.rules = {BoundaryShape::ball, true}}});
  cases.push_back({.id = "W11",
                   .file = "W11.json",
                   .what = "walls that cross, distance alone",
                   .expected = "an end, and the pair is named",
                   .checked = "pieces at most 64; the pair is named, with the reason",
                   .facts = willis_facts::few_pieces,
                   .end = WillisEnd::left_over,
                   .options = {.order_cells = false, .plan = true}});
  cases.push_back({.id = "W11",
                   .file = "W11.json",
                   .what = "the same with order cells",
                   .expected = "cut where they cross",
                   .checked = "no two pieces cross",
                   .facts = willis_facts::cut_where_they_cross});
}

void add_eye_cases(std::vector<WillisHardCase>& cases) {
  cases.push_back({.id = "W8",
                   .file = "W8.json",
                   .what = "the eye in the plane of a wall, at (-5, 0), looking along x",
                   .expected = "edge-on is not shown; others are as they were",
                   .checked = "no piece of the wall is in the order, the other wall is",
                   .facts = willis_facts::first_not_shown});
  cases.push_back(
      {.id = "W9",
       .file = "W9.json",
       .what = "three walls whose points are equally far: (3, 4), (4, 3), (5, 0), in hundreds",
       .expected = "they cannot overlap; whatever the order of the scene, the picture is the same",
       .checked = "equal distances; equal pictures of the surfaces forwards and backwards",
       .facts = willis_facts::equal_distances,
       .clusters = 0});
  cases.push_back({.id = "W12",
                   .file = "W12.json",
                   .what = "five turned houses, eyes on three circles, one a degree",
                   .expected = "whichever corners stand for two pieces, the hidden one is farther",
                   .checked = "all pairs of corners of all pieces that hide another",
                   .facts = willis_facts::any_representative});
  cases.push_back({.id = "W13",
                   .file = "W13.json",
                   .what = "the eye on the end of a wall",
                   .expected = "refused: this is no place to look from; the wall would be edge-on",
                   .checked = "no piece of the wall is in the order, the other wall is",
                   .facts = willis_facts::first_not_shown,
                   .end = WillisEnd::refused});
}

void add_number_cases(std::vector<WillisHardCase>& cases) {
  cases.push_back({.id = "W10",
                   .file = "W10.json",
                   .what = "a wall of 1000, and one unit from it one of 1",
                   .expected =
                       "bisection: pieces by the logarithm of the length, not a thousand; the short wall "
                       "is at exactly its length, so it is cut, too",
                   .checked = "of a side of the long wall 12 to 40 pieces, of the short one two or more",
                   .facts = willis_facts::both_cut,
                   .clusters = 2});
  cases.push_back({.id = "W14",
                   .file = "W14.json",
                   .what = "normals at exactly 90 degrees",
                   .expected = "90 counts as within 90: the rule changes nothing",
                   .checked = "which can hide which, from all sides, with and without the rule",
                   .facts = willis_facts::right_angle});
  cases.push_back({.id = "W14",
                   .file = "W14-beyond.json",
                   .what = "normals 160 degrees apart, both seen, one hiding the other",
                   .expected = "with the rule no cluster and the wrong order; without it cut, and right",
                   .checked = "pictures of the two seen sides, whichever corners stand for them",
                   .facts = willis_facts::beyond_90_degrees});
  cases.push_back({.id = "W15",
                   .file = "W15.json",
                   .what = "walls that begin on another one's plane, or lie in it",
                   .expected = "on the plane is not behind it: only an end that is behind can be hidden",
                   .checked = "which can be hidden, from all sides",
                   .facts = willis_facts::on_the_plane});
  cases.push_back({.id = "W16",
                   .file = "W16.json",
                   .what = "W1 moved by 131072: squares of 2^58 in lattice units",
                   .expected = "the same as W1",
                   .checked = "in the boundary, by both shapes; 2 clusters",
                   .facts = willis_facts::at_the_length,
                   .clusters = 2});
  cases.push_back({.id = "W16",
                   .file = "W16-limit.json",
                   .what = "walls across all coordinates there are, 262143 each way, exactly at their length",
                   .expected = "no number wraps: a cluster, cut, right",
                   .checked = "squared lengths; in the boundary at the length, not below; 2 clusters",
                   .facts = willis_facts::not_overflowing,
                   .clusters = 2});
  cases.push_back({.id = "W16",
                   .file = "W16-limit.json",
                   .what = "the same in space, where their length is the diagonal",
                   .expected = "the same",
                   .checked = the_picture,
                   .options = {},
                   .clusters = 2});
}

}  // namespace

std::vector<WillisHardCase> willis_hard_cases() {
  std::vector<WillisHardCase> cases;
  add_boundary_cases(cases);
  add_touching_cases(cases);
  add_eye_cases(cases);
  add_number_cases(cases);
  std::stable_sort(cases.begin(), cases.end(), [](const WillisHardCase& a, const WillisHardCase& b) {
    return a.id.size() != b.id.size() ? a.id.size() < b.id.size() : a.id < b.id;
  });
  return cases;
}

}  // namespace sightline::harness::report
