// The scene of Jones (1971): opaque matter, and the free space around it cut into convex cells joined by
// openings.
//
// Cells, solids and walls are parallel to the axes, as the paper restricts its program ("Only orthogonal
// lines parallel to one of the axes"). x points right, y up, z away from the viewer. Walls have no thickness.
// An opening is a rectangle shared by exactly two cells. Its ring of vectors says which parts of its outline
// are actual lines (F = 1) and which are artificial edges (F = 0). For scenes of general polyhedra, see
// poly_scene.hpp.
//
// A CellScene may be invalid. check_scene (host/scene/check/cell_scene.hpp) tells; everything that draws or
// encodes scenes expects a checked one.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/geometry/box.hpp"

namespace sightline::scene {

// One side, or part of a side, of an opening's outline; it starts where the previous one ended.
struct RingVector {
  bool actual = false;         // F: a line to draw, not an artificial edge
  std::size_t axis = 0;        // 0, 1, 2 = i, j, k
  std::int32_t magnitude = 0;  // signed, -16384 .. 16383, not 0

  friend bool operator==(const RingVector&, const RingVector&) = default;
};

struct Opening {
  std::array<std::size_t, 2> cells{};  // [0] on the low side of the plane, [1] on the high side
  geometry::Rectangle place;
  std::vector<geometry::Point> ring;  // the four corners in order; the vectors start at ring[0]
  std::vector<RingVector> vectors;

  friend bool operator==(const Opening&, const Opening&) = default;
};

// An actual line, parallel to an axis.
struct Line {
  geometry::Point from{};
  geometry::Point to{};

  friend bool operator==(const Line&, const Line&) = default;
};

struct Cell {
  geometry::Box box;
  std::vector<Line> lines;  // on the cell's boundary, not on the outline of one of its openings

  friend bool operator==(const Cell&, const Cell&) = default;
};

struct CellScene {
  std::string name;  // 1 to 40 printable ASCII characters
  geometry::Box outer;
  std::vector<geometry::Box> solids;
  std::vector<geometry::Rectangle> walls;
  geometry::Point default_view{};
  std::vector<Cell> cells;
  std::vector<Opening> openings;

  friend bool operator==(const CellScene&, const CellScene&) = default;
};

}  // namespace sightline::scene
