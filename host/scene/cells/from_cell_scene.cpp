// See from_cell_scene.hpp.
#include "host/scene/cells/from_cell_scene.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include "host/geometry/box_tree.hpp"
#include "host/scene/cells/builder.hpp"
#include "host/scene/cells/free_rectangles.hpp"

namespace sightline::scene {
namespace {

using geometry::Box;
using geometry::Rectangle;

std::vector<Box> boxes_of(const CellScene& scene) {
  std::vector<Box> boxes;
  for (const Cell& cell : scene.cells) boxes.push_back(cell.box);
  return boxes;
}

void add_lines(CellComplexBuilder& builder, const std::vector<Box>& boxes) {
  const geometry::BoxTree tree(boxes);
  const CellComplex& complex = builder.complex();
  for (std::uint32_t e = 0; e < complex.edges.size(); ++e) {
    const PolyPoint& from = complex.vertices[complex.edges[e].from];
    const PolyPoint& to = complex.vertices[complex.edges[e].to];
    const std::size_t axis = from[0] != to[0] ? 0 : from[1] != to[1] ? 1 : 2;
    Box edge{from, to};
    if (from[axis] > to[axis]) std::swap(edge.low, edge.high);
    tree.for_each_touching(edge, [&](std::uint32_t cell) {
      const std::int32_t low = std::max(edge.low[axis], boxes[cell].low[axis]);
      const std::int32_t high = std::min(edge.high[axis], boxes[cell].high[axis]);
      if (low < high) add_axis_line(builder, e, axis, cell, low, high);
    });
  }
}

bool on_surface(const Rectangle& rectangle, const Box& box) {
  return rectangle.at == box.low[rectangle.axis] || rectangle.at == box.high[rectangle.axis];
}

void add_outer_openings(CellComplexBuilder& builder, const CellScene& scene) {
  std::vector<Rectangle> outer_walls;
  std::copy_if(scene.walls.begin(), scene.walls.end(), std::back_inserter(outer_walls),
               [&](const Rectangle& wall) { return on_surface(wall, scene.outer); });
  FreeRectangles free;
  for (CellNumber c = 0; c < scene.cells.size(); ++c) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const bool high : {false, true}) {
        const Rectangle face = face_of(scene.cells[c].box, axis, high);
        if (face.at != (high ? scene.outer.high : scene.outer.low)[axis]) continue;
        std::vector<Rectangle> walls;
        std::copy_if(outer_walls.begin(), outer_walls.end(), std::back_inserter(walls),
                     [&](const Rectangle& wall) { return wall.overlaps(face); });
        // No limit is given, so find() cannot fail.
        static_cast<void>(free.find(face, walls, std::numeric_limits<std::size_t>::max()));
        for (const Rectangle& opening : free.rectangles())
          add_rectangle_opening(builder, opening, high ? c : outside, high ? outside : c);
      }
    }
  }
}

}  // namespace

CellComplex complex_of(const CellScene& cells, const PolyScene& poly) {
  CellComplexBuilder builder(poly, cells.outer);
  const std::vector<Box> boxes = boxes_of(cells);
  for (const Box& box : boxes) add_box_cell(builder, box);
  for (const Opening& opening : cells.openings) {
    add_rectangle_opening(builder, opening.place, static_cast<CellNumber>(opening.cells[0]),
                          static_cast<CellNumber>(opening.cells[1]));
  }
  add_outer_openings(builder, cells);
  add_lines(builder, boxes);
  return builder.take();
}

}  // namespace sightline::scene
