// Decomposition by BSP: cells contain exactly the free points, straight lines pass from cell to cell through one opening or are
// stopped by
// a face, and lines are where edges touch cells.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <string_view>
#include <utility>

#include "host/base/result.hpp"
#include "host/scene/cells/bsp/decompose.hpp"
#include "host/scene/check/cell_complex.hpp"
#include "host/scene/check/poly_scene.hpp"
#include "host/scene/generate/scene.hpp"
#include "host/scene/model/poly_builder.hpp"
#include "host/scene/model/poly_from_cells.hpp"
#include "host/scene/read/builtin.hpp"
#include "host/scene/read/cell_scene.hpp"
#include "host/scene/read/poly_file.hpp"
#include "tests/host/scene/cells/bsp_prober.hpp"

namespace sightline::scene {
namespace {

PolyScene model(const std::string& name) {
  return read_poly(*builtin_scene_text(name), name, PolyFormat::off)->scene;
}

// Overlapping and nested solids, one with a cavity, and a sheet with a window across them and next to them: everything that a
// checked
// scene may contain.
PolyScene tangled_solids() {
  PolyBuilder builder;
  builder.add_box("first", {0, 0, 0}, {4000, 3000, 2000});
  builder.add_box("across", {1000, -1000, 500}, {3000, 5000, 1500});
  builder.add_box("within", {200, 200, 200}, {900, 900, 900});
  builder.add_box("hollow", {6000, 0, 0}, {9000, 3000, 3000});
  builder.add_box("cavity", {7000, 1000, 1000}, {8000, 2000, 2500});
  builder.add_sheet("window",
                    std::vector<PolyPoint>{
                        {-500, -500, -1500}, {9900, -500, 3700}, {9900, 4500, 6200}, {-500, 4500, 1000}});
  const std::vector<PolyPoint> hole{
      {4500, 500, 1500}, {4400, 1500, 1950}, {5300, 1600, 2450}, {5500, 600, 2050}};
  std::vector<VertexIndex> ring;
  for (const PolyPoint& p : hole) ring.push_back(builder.vertex(p));
  PolyScene scene = builder.take();
  scene.bodies.back().faces[0].holes.push_back(ring);
  PolyBody cavity = scene.bodies[4];
  scene.bodies.erase(scene.bodies.begin() + 4);
  for (PolyFace& face : cavity.faces) {
    std::reverse(face.outline.begin(), face.outline.end());
    scene.bodies[3].faces.push_back(face);
  }
  return scene;
}

// Triangles through each other at the coordinate limit: the planes with the largest coefficients, and corners far from integers.
PolyScene crossed_triangles() {
  std::mt19937 random(11);
  std::uniform_int_distribution<std::int32_t> coordinate(2 - poly_coordinate_limit,
                                                         poly_coordinate_limit - 2);
  PolyBuilder builder;
  for (int i = 0; i < 7; ++i) {
    std::vector<PolyPoint> outline;
    for (int k = 0; k < 3; ++k)
      outline.push_back({coordinate(random), coordinate(random), coordinate(random)});
    builder.add_sheet("", outline);
  }
  return builder.take();
}

// Enlarges small scenes, for tests that need points in general position.
PolyScene enlarge(PolyScene scene, std::int32_t factor) {
  for (PolyPoint& p : scene.vertices)
    for (std::int32_t& c : p) c *= factor;
  return scene;
}

// Small enough to test every cell; half of the touching cubes are removed, so that lines can pass.
PolyScene scene_named(const std::string& name) {
  if (name == "tangled") return tangled_solids();
  if (name == "crossed") return crossed_triangles();
  if (builtin_scene_text(name)) return model(name);
  const std::size_t colon = name.find(':');
  const std::string family = name.substr(0, colon);
  PolyScene scene = *generate_scene(family, std::stoul(name.substr(colon + 1)), 5);
  if (family == "touch")
    std::erase_if(scene.bodies, [n = 0](const PolyBody&) mutable { return n++ * 5 % 13 < 6; });
  return family == "bricks" ? enlarge(std::move(scene), 1000) : scene;
}

TEST(DecomposeBsp, IsTestedOnValidScenes) {
  EXPECT_TRUE(check_poly_scene(tangled_solids()).empty());
  EXPECT_TRUE(check_poly_scene(crossed_triangles()).empty());
}

class DecomposeBspTest : public testing::TestWithParam<const char*> {
 protected:
  Prober prober{scene_named(GetParam())};
};

TEST_P(DecomposeBspTest, EveryFreePointIsInOneCell) {
  int tested = 0;
  for (int i = 0; i < 600; ++i) {
    const PolyPoint p = prober.random_point();
    const std::optional<int> cells = prober.cells_with(p);
    const std::optional<int> solids = prober.solids_with(p);
    if (!cells || !solids) continue;
    ++tested;
    EXPECT_EQ(*cells, *solids > 0 ? 0 : 1) << p[0] << ' ' << p[1] << ' ' << p[2];
  }
  EXPECT_GT(tested, 20);
}

// If it meets no face, a line passes from cell to cell without a gap, each time through exactly one opening.
TEST_P(DecomposeBspTest, StraightLinesPassThroughOpenings) {
  int passed = 0;
  for (int i = 0; i < 200; ++i) {
    const Segment segment{prober.random_point(), prober.random_point()};
    const std::optional<int> faces = prober.faces_met(segment);
    if (!faces) continue;
    const std::vector<Passage> passages = prober.passages(segment);
    int stops = 0;
    for (std::size_t k = 1; k < passages.size(); ++k) {
      const Passage& before = passages[k - 1];
      const Passage& after = passages[k];
      ASSERT_LE(before.stretch.high, after.stretch.low);
      const int openings = before.stretch.high == after.stretch.low
                               ? prober.openings_at(segment, before.cell, after.cell, after.stretch.low)
                               : 0;
      ASSERT_LE(openings, 1);
      (openings == 1 ? passed : stops) += 1;
    }
    if (*faces == 0 && !passages.empty()) {
      EXPECT_EQ(stops, 0);
    }
    if (*faces > 0) {
      EXPECT_LE(stops, *faces);
    }
    if (*faces > 0 && prober.cells_with(segment.from) == 1 && prober.cells_with(segment.to) == 1) {
      EXPECT_GE(stops, 1);
    }
  }
  EXPECT_GT(passed, 20);
}

TEST_P(DecomposeBspTest, LinesAreWhereEdgesTouchCells) {
  const CellComplex& complex = prober.complex();
  for (const ComplexCell& cell : complex.cells) {
    std::size_t next = cell.first_line;
    for (std::uint32_t e = 0; e < complex.edges.size(); ++e) {
      const ComplexEdge& edge = complex.edges[e];
      const Stretch stretch = stretch_in(complex, complex.bounds_of(cell),
                                         {complex.vertices[edge.from], complex.vertices[edge.to]});
      if (!stretch.has_length()) continue;
      ASSERT_LT(next, cell.first_line + cell.line_count);
      const ComplexLine& line = complex.lines[next++];
      EXPECT_EQ(line.edge, e);
      EXPECT_EQ(line.low, stretch.low);
      EXPECT_EQ(line.high, stretch.high);
    }
    EXPECT_EQ(next, cell.first_line + cell.line_count);
  }
}

TEST_P(DecomposeBspTest, OpeningsLieOnBoundsOfTheirCells) {
  const CellComplex& complex = prober.complex();
  for (const ComplexOpening& opening : complex.openings) {
    EXPECT_GE(opening.side_count, 3U);
    for (const bool in_front : {false, true}) {
      const CellNumber number = opening.cells[in_front ? 1 : 0];
      if (number == outside) continue;
      const auto bounds = complex.bounds_of(complex.cells[number]);
      EXPECT_EQ(std::count(bounds.begin(), bounds.end(), HalfSpace{opening.plane, in_front}), 1);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, DecomposeBspTest,
                         testing::Values("boxes:3", "boxes:12", "edgeon:9", "touch:3", "aligned:2", "town:9",
                                         "triangles:12", "bricks:10", "rooms:3", "squares", "tangled",
                                         "crossed"));

std::string problems_of(const PolyScene& scene, const BspOptions& options = {}) {
  std::string text;
  const auto made = decompose_bsp(scene, options);
  for (const base::Error& error : check_complex(*made, scene)) text += error.message() + '\n';
  return text;
}

TEST(DecomposeBsp, MakesValidComplexes) {
  for (const char* name : {"boxes:30", "edgeon:27", "touch:2", "aligned:3", "town:25", "triangles:16",
                           "bricks:12", "rooms:4", "grid", "tori", "tangled", "crossed"}) {
    EXPECT_EQ(problems_of(scene_named(name)), "") << name;
  }
}

TEST(DecomposeBsp, MakesValidComplexesWithoutJoiningLeaves) {
  BspOptions apart;
  apart.join = false;
  for (const char* name : {"town:16", "rooms:3", "squares", "tangled", "crossed"}) {
    EXPECT_EQ(problems_of(scene_named(name), apart), "") << name;
  }
}

TEST(DecomposeBsp, CutsTheSolidsAndWallsOfCellScenes) {
  for (const std::string_view name : builtin_scene_names()) {
    const CellScene cells = *load_cell_scene(std::string(name));
    EXPECT_EQ(problems_of(poly_scene_of(cells)), "") << name;
  }
}

TEST(DecomposeBsp, IsTheSameEachTime) {
  const PolyScene scene = generate_triangles(16);
  const auto first = *decompose_bsp(scene);
  const auto second = *decompose_bsp(scene);
  EXPECT_EQ(first.planes, second.planes);
  EXPECT_EQ(first.bounds, second.bounds);
  EXPECT_EQ(first.sides, second.sides);
  EXPECT_EQ(first.opening_numbers, second.opening_numbers);
}

// Around a block of cubes that touch face to face there are no more cuts than around one box.
TEST(DecomposeBsp, JoinsCellsWhoseUnionIsConvex) {
  EXPECT_EQ(decompose_bsp(generate_boxes(1))->cells.size(), 6U);
  EXPECT_EQ(decompose_bsp(generate_touch(3))->cells.size(), 6U);
  BspOptions apart;
  apart.join = false;
  EXPECT_GT(decompose_bsp(generate_touch(3), apart)->cells.size(), 6U);
}

TEST(DecomposeBsp, NamesTheLimitThatStopsIt) {
  const auto empty = decompose_bsp(PolyScene{});
  EXPECT_EQ(empty.error().found, "found no face");
  const auto large = decompose_bsp(generate_boxes(10), {.most_leaves = 20});
  EXPECT_EQ(large.error().found, "the planes of the faces cut space into more than 20 cells");
  EXPECT_TRUE(decompose_bsp(generate_boxes(1), {.most_leaves = 7}));
}

}  // namespace
}  // namespace sightline::scene
