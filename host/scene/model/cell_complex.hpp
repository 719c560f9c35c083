// Free space cut into convex cells joined by openings, in general position: the input of Jones's algorithm
// (1971) without its restriction to axis-parallel cells.
//
// Everything is given by planes with integer coefficients. An opening is a convex polygon in a plane, bounded
// by the lines where other planes cross it. Its corners, which need not be integer points, are never
// computed. So numbers do not grow, however often space is cut: each plane is an original plane of the scene
// or parallel to an axis.
//
// Edges are those of the scene of polyhedra that the complex was made from (picture::edges_of: every side of
// every face, once). A cell lists the parts of edges on its closure, so a line may be in several cells.
//
// The complex fills a box, the outer box. From outside it is entered through the openings one of whose cells
// is `outside`. The outer box hides nothing and has no lines. All arrays are flat: the rows of a cell or an
// opening are consecutive, so that a million cells load in linear time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "host/geometry/box.hpp"
#include "host/geometry/predicates.hpp"
#include "host/scene/model/complex_lines.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

using CellNumber = std::uint32_t;
inline constexpr CellNumber outside = std::numeric_limits<CellNumber>::max();

// The half-space where a plane is not positive; if turned, not negative. What it bounds lies in it.
struct HalfSpace {
  std::uint32_t plane = 0;  // index into planes
  bool turned = false;

  friend bool operator==(const HalfSpace&, const HalfSpace&) = default;
};

// The polygon of the points of `plane` that are in the half-spaces of all sides. It has an area. Its sides
// are in order, counterclockwise as seen from the side that the plane's normal points to.
struct ComplexOpening {
  std::array<CellNumber, 2> cells{};  // [0] on the negative side of the plane, [1] on the positive
  std::uint32_t plane = 0;
  std::uint32_t first_side = 0;
  std::uint32_t side_count = 0;
};

struct ComplexEdge {
  VertexIndex from = 0;
  VertexIndex to = 0;  // above from

  friend bool operator==(const ComplexEdge&, const ComplexEdge&) = default;
};

struct ComplexCell {
  std::uint32_t first_bound = 0;  // its half-spaces; the cell is their intersection
  std::uint32_t bound_count = 0;
  std::uint32_t first_line = 0;
  std::uint32_t line_count = 0;
  std::uint32_t first_opening = 0;  // into opening_numbers
  std::uint32_t opening_count = 0;
};

struct CellComplex {
  geometry::Box outer;
  std::vector<PolyPoint> vertices;  // as in the scene
  std::vector<ComplexEdge> edges;   // ascending by (from, to)
  std::vector<geometry::Plane> planes;
  std::vector<ComplexCell> cells;
  std::vector<HalfSpace> bounds;
  ComplexLines lines;
  std::vector<ComplexOpening> openings;
  std::vector<HalfSpace> sides;
  std::vector<std::uint32_t> opening_numbers;  // by cell

  [[nodiscard]] std::span<const HalfSpace> bounds_of(const ComplexCell& cell) const {
    return std::span(bounds).subspan(cell.first_bound, cell.bound_count);
  }
  [[nodiscard]] ComplexLines::Rows lines_of(const ComplexCell& cell) const {
    return lines.rows(cell.first_line, cell.line_count);
  }
  [[nodiscard]] std::span<const std::uint32_t> openings_of(const ComplexCell& cell) const {
    return std::span(opening_numbers).subspan(cell.first_opening, cell.opening_count);
  }
  [[nodiscard]] std::span<const HalfSpace> sides_of(const ComplexOpening& opening) const {
    return std::span(sides).subspan(opening.first_side, opening.side_count);
  }
};

}  // namespace sightline::scene
