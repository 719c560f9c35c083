// The list of the hard cases P1 to P22.
#include "host/report/hard_cases/plantinga.hpp"
#include "host/report/hard_cases/plantinga_checks.hpp"

namespace sightline::harness::report {

namespace {

using Cases = std::vector<PlantingaHardCase>;

void add_double_roots(Cases& cases) {
  cases.push_back({.id = "P1",
                   .file = "P1.txt",
                   .what = "three edges whose quadratic has a double root at theta = 0",
                   .expected = "they touch without changing order: no event",
                   .checked = "form (-88, 0, 0); no direction",
                   .form = {{-88, 0, 0}}});
  cases.push_back({.id = "P1b",
                   .file = "P1b.txt",
                   .what = "the same at tan theta = -1/4",
                   .expected = "no event",
                   .checked = "form (-256, -128, -16); no direction",
                   .form = {{-256, -128, -16}}});
  cases.push_back({.id = "P1c",
                   .file = "P1c.txt",
                   .what = "the same at tan theta = 1/7",
                   .expected = "no event",
                   .checked = "form (-196, 56, -4); no direction",
                   .form = {{-196, 56, -4}}});
  cases.push_back({.id = "P1d",
                   .file = "P1d.txt",
                   .what = "a double root because two of the edges are on one line of the image",
                   .expected = "no event of three edges: their vertices have events there",
                   .checked = "form (-81, 108, -36); no direction",
                   .form = {{-81, 108, -36}}});
  cases.push_back({.id = "P1d",
                   .file = "P1d-2.txt",
                   .what = "the same at tan theta = -1",
                   .expected = "no event of three edges",
                   .checked = "no direction"});
  cases.push_back({.id = "P2",
                   .file = "P2-apart.txt",
                   .what = "P1 in millions, moved by one: two roots 0.0015 rad apart",
                   .expected = "two potential events, and their opposites",
                   .checked = "4 directions",
                   .directions = 4});
  cases.push_back({.id = "P2",
                   .file = "P2-none.txt",
                   .what = "moved by one the other way",
                   .expected = "no root",
                   .checked = "no direction"});
  cases.push_back({.id = "P2",
                   .file = "P2b-apart.txt",
                   .what = "P1b in millions, moved by one: two roots 0.0011 rad apart",
                   .expected = "two potential events, and their opposites",
                   .checked = "4 directions",
                   .directions = 4});
  cases.push_back({.id = "P2",
                   .file = "P2b-none.txt",
                   .what = "moved by one the other way",
                   .expected = "no root",
                   .checked = "no direction"});
}

void add_roots(Cases& cases) {
  cases.push_back({.id = "P3",
                   .file = "P3.txt",
                   .what = "two irrational roots inside all three edges",
                   .expected = "two potential events, and their opposites",
                   .checked = "form (129, 111, 18); 4 directions; tan theta = -0.643692555, -0.216772561",
                   .directions = 4,
                   .tangents = {-0.643692555, -0.216772561},
                   .form = {{129, 111, 18}}});
  cases.push_back({.id = "P4",
                   .file = "P4.txt",
                   .what = "a root at 90 degrees, where the tangent is infinite",
                   .expected = "a direction like others",
                   .checked = "of the lines 4 directions: 1:0, -2:3 and opposites",
                   .directions = 4,
                   .there = {{1, 0}, {-1, 0}, {-2, 3}, {2, -3}},
                   .form = {{0, -72, -48}},
                   .whole_lines = true});
  cases.push_back({.id = "P5",
                   .file = "P5.txt",
                   .what = "a vertex meets an edge at 90 degrees",
                   .expected = "a direction like others",
                   .checked = "1:0 and -1:0",
                   .directions = 2,
                   .there = {{1, 0}, {-1, 0}}});
  cases.push_back({.id = "P6",
                   .file = "P6.txt",
                   .what = "two events 2.5e-13 rad apart",
                   .expected = "two, in order",
                   .checked = "4 directions: 832040:1346269, 1346269:2178309 and opposites",
                   .directions = 4,
                   .there = {{832040, 1346269}, {1346269, 2178309}}});
  cases.push_back({.id = "P7",
                   .file = "P7.txt",
                   .what = "two vertices on one line of sight meet one edge",
                   .expected = "one group",
                   .checked = "1:2 and its opposite, each once",
                   .directions = 2,
                   .there = {{1, 2}, {-1, -2}}});
}

void add_contacts(Cases& cases) {
  cases.push_back({.id = "P8",
                   .file = "P8.txt",
                   .what = "a vertex at the height of a level edge",
                   .expected = "it slides along the edge's line: no event",
                   .checked = "no direction"});
  cases.push_back({.id = "P9",
                   .file = "P9.json",
                   .what = "level edges of one height: boxes on the ground, equally high",
                   .expected = "no T-junction of two of them; what is on one line is hidden from both sides",
                   .checked = "no such end in a full turn",
                   .turn = level_edges_never_cross});
  cases.push_back({.id = "P10",
                   .file = "P10.txt",
                   .what = "two vertical edges coincide as a whole",
                   .expected = "all vertices meet in one group",
                   .checked = "1:2 and its opposite, each once",
                   .directions = 2,
                   .there = {{1, 2}, {-1, -2}}});
  cases.push_back({.id = "P11",
                   .file = "P11.txt",
                   .what = "a vertex on the axis",
                   .expected = "a vertex like others",
                   .checked = "3:4 and its opposite",
                   .directions = 2,
                   .there = {{3, 4}, {-3, -4}}});
  cases.push_back({.id = "P12",
                   .file = "P12.txt",
                   .what = "an edge on the axis",
                   .expected = "an edge like others",
                   .checked = "3:4 and its opposite",
                   .directions = 2,
                   .there = {{3, 4}, {-3, -4}}});
  cases.push_back({.id = "P13",
                   .file = "P13.txt",
                   .what = "three edges from one vertex: the quadratic is 0",
                   .expected = "no event",
                   .checked = "form (0, 0, 0); no direction",
                   .form = {{0, 0, 0}}});
  cases.push_back({.id = "P13",
                   .file = "P13-parallel.txt",
                   .what = "three parallel edges: the quadratic is 0",
                   .expected = "no event",
                   .checked = "form (0, 0, 0); no direction",
                   .form = {{0, 0, 0}}});
  cases.push_back({.id = "P13",
                   .file = "P13-face.txt",
                   .what = "three edges of the plane x = 2, which turns over at theta = 0",
                   .expected = "a double root: no event of three edges, the face has one",
                   .checked = "of the lines no direction",
                   .whole_lines = true});
  cases.push_back({.id = "P14",
                   .file = "P14.txt",
                   .what = "the quadratic is a constant: two parallel edges and a third",
                   .expected = "no event",
                   .checked = "form (0, 0, -700); of the lines no direction",
                   .form = {{0, 0, -700}},
                   .whole_lines = true});
}

void add_faces(Cases& cases) {
  cases.push_back({.id = "P15",
                   .file = "P15.json",
                   .what = "faces edge-on: a slab with normals (3, 0, 4) and (4, 0, -3)",
                   .expected = "all that a face changes happens in one group",
                   .checked = "4 groups in a turn: 4:-3, 3:4 and opposites",
                   .turn = four_faces_edge_on});
  cases.push_back({.id = "P16",
                   .file = "P16.json",
                   .what = "a level sheet before a box: edge-on always",
                   .expected = "it hides nothing",
                   .checked = "no edge ends on it in a full turn",
                   .turn = level_sheet_hides_nothing});
  cases.push_back({.id = "P17",
                   .file = "P17.txt",
                   .what = "an edge begins where two others cross",
                   .expected = "no event of three edges there",
                   .checked = "none at 0:1",
                   .not_there = {{0, 1}, {0, -1}}});
  cases.push_back({.id = "P17",
                   .file = "P17-vertex.txt",
                   .what = "its first vertex and one of the two",
                   .expected = "an event of the vertex",
                   .checked = "0:1 and its opposite",
                   .directions = 2,
                   .there = {{0, 1}, {0, -1}}});
  cases.push_back({.id = "P18",
                   .file = "",
                   .what = "a model that is its own mirror image, Tori",
                   .expected = "events in exact mirrored groups, whatever doubles say",
                   .checked = "the mirror image of every group that changes how many pieces an edge has is a "
                              "group, compared exactly",
                   .turn = mirrored_events,
                   .model = "tori"});
  cases.push_back({.id = "P19",
                   .file = "P19.txt",
                   .what = "an event at pi, where the range ends",
                   .expected = "it is there once",
                   .checked = "0:1 and 0:-1",
                   .directions = 2,
                   .there = {{0, 1}, {0, -1}}});
  cases.push_back({.id = "P20",
                   .file = "P20.json",
                   .what = "steps of 30 degrees over many events, three tilted boxes",
                   .expected = "every frame as from scratch, forwards and backwards",
                   .checked = "27 frames, half a turn at once",
                   .turn = large_steps});
  cases.push_back({.id = "P21",
                   .file = "P21.json",
                   .what = "two boxes whose fronts are in one plane",
                   .expected = "neither hides any of the other's front from before it",
                   .checked = "all edges of the fronts are seen whole",
                   .turn = fronts_always_seen});
  cases.push_back({.id = "P22",
                   .file = "",
                   .what = "the paper's Table 1, row Grid",
                   .expected = "1383 events of 105 edges are 13.2 an edge, not 16.3: do not tune to this row",
                   .checked = "the other five rows agree with themselves",
                   .table = only_grid_disagrees});
}

}  // namespace

std::vector<PlantingaHardCase> plantinga_hard_cases() {
  Cases cases;
  add_double_roots(cases);
  add_roots(cases);
  add_contacts(cases);
  add_faces(cases);
  return cases;
}

}  // namespace sightline::harness::report
