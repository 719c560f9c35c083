// Decomposition by grid and by hand: the result is valid, fills space and names every edge.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/geometry/box_tree.hpp"
#include "host/scene/cells/decompose.hpp"
#include "host/scene/cells/free_rectangles.hpp"
#include "host/scene/cells/from_cell_scene.hpp"
#include "host/scene/cells/grid/decompose.hpp"
#include "host/scene/check/cell_complex.hpp"
#include "host/scene/generate/random.hpp"
#include "host/scene/generate/scene.hpp"
#include "host/scene/model/poly_builder.hpp"
#include "host/scene/model/poly_from_cells.hpp"
#include "tests/host/scene/scene_support.hpp"

namespace sightline::scene {
namespace {

using geometry::Rational;
using geometry::Rectangle;

CellComplex grid(const PolyScene& scene) {
  auto result = decompose_grid(scene);
  if (!result) {
    ADD_FAILURE() << scene.name << ": " << result.error().message();
    return {};
  }
  return std::move(*result);
}

void expect_possible(const CellComplex& complex, const PolyScene& scene) {
  for (const base::Error& error : check_complex(complex, scene))
    ADD_FAILURE() << scene.name << ": " << error.message();
}

PolyScene boxes(const std::vector<std::pair<PolyPoint, PolyPoint>>& places) {
  PolyBuilder builder;
  for (const auto& [low, high] : places) builder.add_box("box", low, high);
  return builder.take();
}

// The cells of the hand-made scenes, as in the paper.
TEST(DecomposeGrid, BuiltInScenes) {
  const std::map<std::string, std::size_t> expected{
      {"house", 3}, {"roberts", 12}, {"corridor8", 8}, {"corridor32", 32}};
  for (const std::string_view name : builtin_scene_names()) {
    const CellScene cells = builtin_scene(name);
    const PolyScene scene = poly_scene_of(cells);
    const CellComplex by_hand = complex_of(cells, scene);
    expect_possible(by_hand, scene);
    EXPECT_EQ(by_hand.cells.size(), cells.cells.size());
    const CellComplex complex = grid(scene);
    expect_possible(complex, scene);
    if (const auto count = expected.find(std::string(name)); count != expected.end()) {
      EXPECT_EQ(complex.cells.size(), count->second) << name;
    }
  }
}

TEST(DecomposeGrid, GeneratedScenes) {
  for (const auto& [family, size] : std::vector<std::pair<const char*, std::size_t>>{{"boxes", 10},
                                                                                     {"rooms", 4},
                                                                                     {"rooms", 10},
                                                                                     {"bricks", 10},
                                                                                     {"town", 9},
                                                                                     {"touch", 3},
                                                                                     {"aligned", 4}}) {
    const PolyScene scene = *generate_scene(family, size);
    expect_possible(grid(scene), scene);
  }
}

TEST(DecomposeGrid, ABoxIsSixCells) {
  const PolyScene scene = boxes({{{0, 0, 0}, {4, 5, 6}}});
  const CellComplex complex = grid(scene);
  expect_possible(complex, scene);
  EXPECT_EQ(complex.outer, (geometry::Box{{-1, -1, -1}, {5, 6, 7}}));
  EXPECT_EQ(complex.cells.size(), 6U);
  EXPECT_EQ(complex.edges.size(), 12U);
  EXPECT_EQ(complex.planes.size(), 12U);
  const auto to_outside = std::count_if(complex.openings.begin(), complex.openings.end(), [](const auto& o) {
    return o.cells[0] == outside || o.cells[1] == outside;
  });
  // Below and above: 5 faces each; in front and behind, left and right: as they grew.
  EXPECT_GE(to_outside, 6 + 4);
}

// Doors and hatches need no additional planes.
TEST(DecomposeGrid, ARoomIsNineUnits) {
  const PolyScene scene = generate_rooms(1);
  EXPECT_FALSE(why_no_grid(scene, {9}));
  const auto refused = why_no_grid(scene, {8});
  ASSERT_TRUE(refused);
  EXPECT_NE(refused->found.find("3 x 3 x 1"), std::string::npos) << refused->found;
  // But a wall's door is cut out of the space that the wall leaves free.
  const auto cut = decompose_grid(scene, {9});
  ASSERT_FALSE(cut);
  EXPECT_EQ(cut.error().place, "x = 0");
}

TEST(DecomposeGrid, BodiesThatTouchOverlapOrHaveSplitFaces) {
  for (const PolyScene& scene : {boxes({{{0, 0, 0}, {4, 4, 4}}, {{4, 0, 0}, {8, 4, 4}}}),
                                 boxes({{{0, 0, 0}, {4, 4, 4}}, {{2, 2, 2}, {6, 6, 6}}}),
                                 boxes({{{0, 0, 0}, {9, 9, 9}}, {{2, 2, 2}, {6, 6, 6}}})}) {
    expect_possible(grid(scene), scene);
  }
  PolyScene split = boxes({{{0, 0, 0}, {4, 4, 4}}});
  const VertexIndex a = static_cast<VertexIndex>(split.vertices.size());
  // The face x = 0 as two halves, with a vertex in two of its sides.
  split.vertices.push_back({0, 1, 0});
  split.vertices.push_back({0, 1, 4});
  for (PolyFace& face : split.bodies[0].faces) {
    const auto is = [&](VertexIndex v, int y, int z) { return split.vertices[v] == PolyPoint{0, y, z}; };
    for (std::size_t i = 0; i < face.outline.size(); ++i) {
      const VertexIndex from = face.outline[i];
      const VertexIndex to = face.outline[(i + 1) % face.outline.size()];
      for (const VertexIndex added : {a, a + 1}) {
        const int z = split.vertices[added][2];
        if ((is(from, 0, z) && is(to, 4, z)) || (is(from, 4, z) && is(to, 0, z))) {
          face.outline.insert(face.outline.begin() + static_cast<std::ptrdiff_t>(i) + 1, added);
          break;
        }
      }
    }
  }
  auto& faces = split.bodies[0].faces;
  const auto low = std::find_if(faces.begin(), faces.end(), [&](const PolyFace& face) {
    return std::all_of(face.outline.begin(), face.outline.end(),
                       [&](VertexIndex v) { return split.vertices[v][0] == 0; });
  });
  ASSERT_NE(low, faces.end());
  PolyFace below;
  PolyFace above;
  for (const VertexIndex v : low->outline) {
    if (split.vertices[v][1] <= 1) below.outline.push_back(v);
    if (split.vertices[v][1] >= 1) above.outline.push_back(v);
  }
  *low = below;
  faces.push_back(above);
  const CellComplex complex = grid(split);
  expect_possible(complex, split);
  EXPECT_EQ(complex.cells.size(), 6U);
}

TEST(DecomposeGrid, WhatIsNotParallelToTheAxesIsNamed) {
  PolyBuilder builder;
  builder.add_box("box", {0, 0, 0}, {2, 2, 2});
  const std::array<PolyPoint, 3> slanted{{{5, 0, 0}, {6, 1, 0}, {5, 0, 4}}};
  builder.add_sheet("slanted", slanted);
  const auto refused = why_no_grid(builder.scene());
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->place, "body 1, face 0");
  const PolyScene triangles = generate_triangles(2);
  EXPECT_FALSE(decompose_grid(triangles));
  EXPECT_FALSE(decompose(triangles, DecompositionMethod::grid));
  EXPECT_EQ(decomposition_of(triangles)->method, DecompositionMethod::bsp);
  PolyBuilder flat;
  const std::array<PolyPoint, 3> triangle{{{0, 0, 0}, {0, 4, 0}, {0, 0, 4}}};
  flat.add_sheet("triangle", triangle);
  EXPECT_NE(why_no_grid(flat.scene())->found.find("side"), std::string::npos);
}

// Boxes that do not touch: every edge is completely on cells.
TEST(DecomposeGrid, EdgesAreCovered) {
  const PolyScene scene = generate_boxes(30, 3);
  const CellComplex complex = grid(scene);
  std::vector<std::vector<std::pair<Rational, Rational>>> parts(complex.edges.size());
  for (const ComplexCell& cell : complex.cells)
    for (const ComplexLine& line : complex.lines_of(cell)) parts[line.edge].push_back({line.low, line.high});
  for (std::size_t e = 0; e < parts.size(); ++e) {
    std::sort(parts[e].begin(), parts[e].end());
    Rational reached = 0;
    for (const auto& [low, high] : parts[e])
      if (low <= reached) reached = std::max(reached, high);
    EXPECT_EQ(reached, Rational(1)) << "edge " << e;
  }
}

// A building of more rows than one band, with walls in both bands.
TEST(DecomposeGrid, LinesAreIndexedByEdge) {
  const auto cut = decompose_grid(generate_big_rooms(130));
  const CellComplex& complex = *cut;
  std::size_t unordered = 0;
  std::size_t lines = 0;
  for (const ComplexCell& cell : complex.cells) {
    const auto row = complex.lines_of(cell);
    lines += row.size();
    for (std::size_t i = 1; i < row.size(); ++i) unordered += row.edge(i - 1) < row.edge(i) ? 0 : 1;
  }
  EXPECT_EQ(unordered, 0U);
  EXPECT_EQ(lines, complex.lines.size());
}

TEST(FreeRectangles, CoverFreeSpaceOnce) {
  SceneRandom random(11);
  FreeRectangles free;
  for (int round = 0; round < 200; ++round) {
    const Rectangle whole{1, 7, {geometry::Span{-5, 5}, geometry::Span{0, 8}}};
    std::vector<Rectangle> covers(static_cast<std::size_t>(random.mod(5)));
    for (Rectangle& cover : covers) {
      cover = whole;
      for (geometry::Span& side : cover.sides) {
        side.low = random.mod(14) - 7;
        side.high = side.low + 1 + random.mod(6);
      }
    }
    ASSERT_TRUE(free.find(whole, covers, 1000));
    const auto count = [](std::span<const Rectangle> among, int u, int v) {
      return std::count_if(among.begin(), among.end(), [&](const Rectangle& r) {
        return r.sides[0].low <= u && u < r.sides[0].high && r.sides[1].low <= v && v < r.sides[1].high;
      });
    };
    for (int u = -5; u < 5; ++u)
      for (int v = 0; v < 8; ++v)
        ASSERT_EQ(count(free.rectangles(), u, v), count(covers, u, v) > 0 ? 0 : 1) << round;
    EXPECT_FALSE(free.find(whole, covers, 0));
  }
}

TEST(BoxTree, FindsAllThatTouch) {
  SceneRandom random(5);
  const auto box = [&] {
    geometry::Box b;
    for (std::size_t a = 0; a < 3; ++a) {
      b.low[a] = random.mod(20);
      b.high[a] = b.low[a] + random.mod(6);
    }
    return b;
  };
  std::vector<geometry::Box> all(100);
  std::generate(all.begin(), all.end(), box);
  const geometry::BoxTree tree(all);
  for (int round = 0; round < 200; ++round) {
    const geometry::Box query = box();
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < all.size(); ++i) {
      bool touch = true;
      for (std::size_t a = 0; a < 3; ++a)
        touch = touch && all[i].low[a] <= query.high[a] && query.low[a] <= all[i].high[a];
      if (touch) expected.push_back(i);
    }
    std::vector<std::uint32_t> found;
    tree.for_each_touching(query, [&](std::uint32_t i) { found.push_back(i); });
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found, expected);
  }
}

}  // namespace
}  // namespace sightline::scene
