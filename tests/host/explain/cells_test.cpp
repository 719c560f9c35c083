// The shapes of cells and portals, the graph of a lesson, and the drawing of the cells.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "host/explain/cell_diagrams.hpp"
#include "host/explain/cell_shapes.hpp"
#include "host/explain/explain.hpp"
#include "host/scene/cells/decompose.hpp"
#include "host/scene/read/builtin.hpp"
#include "host/scene/read/load.hpp"
#include "tests/host/explain/load_scene.hpp"

namespace sightline::explain {
namespace {

double largest_extent(const scene::CellComplex& complex) {
  double size = 0;
  for (std::size_t a = 0; a < 3; ++a) size = std::max(size, static_cast<double>(complex.outer.high[a]) - static_cast<double>(complex.outer.low[a]));
  return size;
}

// How far a point is outside a half-space; negative inside.
double outside_by(const scene::CellComplex& complex, const scene::HalfSpace& bound, const Space& p) {
  const geometry::Plane& plane = complex.planes[bound.plane];
  const Space normal = geometry::real_vector(plane.normal);
  return (bound.turned ? -1 : 1) * (geometry::dot(normal, p) - static_cast<double>(plane.offset)) / geometry::length(normal);
}

TEST(CellEdges, OfABoxAreItsTwelve) {
  for (const char* const name : {"house", "street4", "roberts"}) {
    const scene::LoadedScene source = load_scene(name);
    const scene::CellComplex complex = *scene::own_cells(source);
    ASSERT_EQ(complex.cells.size(), source.cells->cells.size());
    for (scene::CellNumber cell = 0; cell < complex.cells.size(); ++cell) {
      const auto& box = source.cells->cells[cell].box;
      const auto edges = edges_of(complex, cell);
      EXPECT_EQ(edges.size(), 12U) << name << ", cell " << cell;
      for (const CellEdge& edge : edges)
        for (const Space& end : {edge.from, edge.to})
          for (std::size_t a = 0; a < 3; ++a) EXPECT_LT(std::min(std::abs(end[a] - box.low[a]), std::abs(end[a] - box.high[a])), 1e-6) << name;
      const Space middle = middle_of(edges);
      for (std::size_t a = 0; a < 3; ++a) EXPECT_NEAR(middle[a], (box.low[a] + box.high[a]) / 2.0, 1e-6) << name;
    }
  }
}

// Euler: V - E + F = 2. Each edge has two sides, and each side at least three edges.
TEST(CellEdges, FormAConvexPolyhedron) {
  std::size_t cells = 0;
  for (const char* const name : {"prisms-4", "triangles-4", "boxes-10"}) {
    const scene::LoadedScene source = load_scene(name);
    const auto complex = scene::decompose(source.scene, scene::DecompositionMethod::bsp);
    ASSERT_TRUE(complex) << name;
    const double fine = largest_extent(*complex) * 1e-7;
    for (scene::CellNumber cell = 0; cell < complex->cells.size(); ++cell, ++cells) {
      const auto edges = edges_of(*complex, cell);
      std::vector<Space> corners;
      std::set<Space> sides;
      for (const CellEdge& edge : edges) {
        sides.insert(edge.sides.begin(), edge.sides.end());
        for (const Space& end : {edge.from, edge.to})
          if (std::none_of(corners.begin(), corners.end(), [&](const Space& c) { return geometry::length(geometry::difference(c, end)) < fine; }))
            corners.push_back(end);
      }
      EXPECT_EQ(corners.size() + sides.size(), edges.size() + 2) << name << ", cell " << cell;
      for (const scene::HalfSpace& bound : complex->bounds_of(complex->cells[cell])) EXPECT_LT(outside_by(*complex, bound, middle_of(edges)), 0) << name;
    }
  }
  EXPECT_GT(cells, 50U);
}

TEST(PortalCorners, AreOnBothCells) {
  for (const char* const name : {"house", "street4"}) {
    const scene::CellComplex complex = *scene::own_cells(load_scene(name));
    for (std::uint32_t n = 0; n < complex.openings.size(); ++n) {
      const auto corners = corners_of(complex, n);
      EXPECT_EQ(corners.size(), complex.openings[n].side_count);
      for (const scene::CellNumber cell : complex.openings[n].cells) {
        if (cell == scene::outside) continue;
        for (const scene::HalfSpace& bound : complex.bounds_of(complex.cells[cell]))
          for (const Space& corner : corners) EXPECT_LT(outside_by(complex, bound, corner), 1e-6) << name << ", portal " << n;
      }
    }
  }
}

// Two points on a line of sight have one place, and the nearer one is on the side that faces the viewer.
TEST(ObliqueView, ShowsTheFrontAndTheTopAndTheRight) {
  const ObliqueView view({true, {0, 0, -100}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}});
  EXPECT_EQ(view.at({0, 0, 0}), (Point{0, 0}));
  EXPECT_EQ(view.at({2, 3, 0}), (Point{2, 3}));
  EXPECT_GT(view.at({0, 0, 1})[0], 0);
  EXPECT_GT(view.at({0, 0, 1})[1], 0);
  EXPECT_TRUE(view.faces_viewer({0, 0, -1}));
  EXPECT_TRUE(view.faces_viewer({1, 0, 0}));
  EXPECT_TRUE(view.faces_viewer({0, 1, 0}));
  for (const Space& back : {Space{0, 0, 1}, Space{-1, 0, 0}, Space{0, -1, 0}}) EXPECT_FALSE(view.faces_viewer(back));
  // A camera that looks along -x with z upwards.
  const ObliqueView turned({true, {100, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  EXPECT_EQ(turned.at({0, 2, 3}), (Point{2, 3}));
}

// Jones 1971, Fig. 2 to 5: three rooms, each joined to the others. From the living room the kitchen is seen through its
// opening, and again through the dining room and the hatch.
TEST(LessonOfJones, ShowsTheGraphOfThePaper) {
  const scene::LoadedScene source = load_scene("house");
  const auto lesson = explain_scene(*find_explainer("jones"), source, source.scene.camera);
  ASSERT_TRUE(lesson);
  ASSERT_EQ(lesson->sheets.size(), 3U);
  const scene::CellNumber living = [&] {
    const auto& eye = source.scene.camera.eye;
    for (scene::CellNumber n = 0; n < 3; ++n) {
      const auto& box = source.cells->cells[n].box;
      bool inside = true;
      for (std::size_t a = 0; a < 3; ++a) inside = inside && box.low[a] < eye[a] && eye[a] < box.high[a];
      if (inside) return n;
    }
    return scene::outside;
  }();
  ASSERT_NE(living, scene::outside);
  std::size_t arcs = 0;
  std::size_t nodes = 0;
  std::set<std::string> avenues;
  std::set<std::string> entered;
  for (const Step& step : lesson->steps)
    for (const Layer& layer : step.changes) {
      if (layer.sheet != 2) continue;
      if (layer.name.starts_with("avenue ")) avenues.insert(layer.name.substr(7));
      if (layer.name.starts_with("cell ") && !layer.marks.empty()) entered.insert(layer.name);
      if (layer.name != "all cells") continue;
      for (const Mark& mark : layer.marks) {
        arcs += mark.kind == Mark::Kind::line ? 1 : 0;
        nodes += mark.kind == Mark::Kind::dot ? 1 : 0;
      }
    }
  EXPECT_EQ(nodes, 3U);
  EXPECT_EQ(arcs, 3U);
  EXPECT_EQ(entered.size(), 3U);
  // Two avenues leave the living room. One goes on from one of the other rooms to the other.
  ASSERT_EQ(avenues.size(), 3U);
  const std::string from_living = std::to_string(living) + " ";
  EXPECT_EQ(std::count_if(avenues.begin(), avenues.end(), [&](const std::string& a) { return a.starts_with(from_living); }), 2);
  EXPECT_TRUE(std::none_of(avenues.begin(), avenues.end(), [&](const std::string& a) { return a.ends_with(" " + std::to_string(living)); }));
}

TEST(CellDiagrams, ShowEveryPortalFromBothSides) {
  const scene::LoadedScene source = load_scene("house");
  const scene::CellComplex complex = *cells_of_search(source);
  EXPECT_EQ(complex.openings.size(), source.cells->openings.size());
  const auto drawing = cell_diagrams(complex, source.scene.camera);
  ASSERT_TRUE(drawing);
  std::size_t sides = 0;
  for (const scene::ComplexCell& cell : complex.cells)
    for (const std::uint32_t n : complex.openings_of(cell)) sides += complex.openings[n].side_count;
  std::size_t drawn = 0;
  for (const picture::DrawingLine& line : drawing->lines) drawn += drawing->layers[line.layer].label == "portals" ? 1 : 0;
  EXPECT_EQ(drawn, sides + 3) << "and three arcs of the graph";
  for (const picture::DrawingPoint& p : drawing->points) {
    EXPECT_GE(p.x, 0);
    EXPECT_GE(p.y, 0);
    EXPECT_LE(p.x, drawing->width);
    EXPECT_LE(p.y, drawing->height);
  }
}

TEST(CellDiagrams, HaveALimit) {
  scene::CellComplex complex;
  complex.cells.resize(most_cell_diagrams + 1);
  const auto drawing = cell_diagrams(complex, {});
  ASSERT_FALSE(drawing);
  EXPECT_NE(drawing.error().message().find("found 1001 cells, expected at most 1000"), std::string::npos) << drawing.error().message();
}

}  // namespace
}  // namespace sightline::explain
