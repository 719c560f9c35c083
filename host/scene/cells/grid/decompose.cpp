// See decompose.hpp.
#include "host/scene/cells/grid/decompose.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/cells/builder.hpp"
#include "host/scene/cells/free_rectangles.hpp"
#include "host/scene/cells/grid/cells.hpp"
#include "host/scene/cells/grid/face.hpp"
#include "host/scene/cells/grid/portals.hpp"
#include "host/scene/cells/grid/space.hpp"
#include "host/scene/check/problems.hpp"

namespace sightline::scene {
namespace {

using geometry::Box;
using geometry::Rectangle;

std::optional<base::Error> fault_of_faces(const PolyScene& scene) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    for (std::size_t f = 0; f < scene.bodies[b].faces.size(); ++f) {
      const PolyFace& face = scene.bodies[b].faces[f];
      const std::string place = "body " + std::to_string(b) + ", face " + std::to_string(f);
      if (!grid_axis_of(scene, face))
        return base::Error{"", place, "is not parallel to two axes, as a grid needs"};
      if (!has_grid_sides(scene, face))
        return base::Error{"", place, "has a side that is not parallel to an axis, as a grid needs"};
    }
  }
  return std::nullopt;
}

std::optional<base::Error> fault_of_size(const GridPlanes& planes, const GridOptions& options) {
  const std::size_t most_units = std::min(options.most_units, GridSpace::most_units);
  if (planes.all_units() <= static_cast<double>(most_units)) return std::nullopt;
  return base::Error{"", "",
                     "a grid of " + std::to_string(planes.units(0)) + " x " +
                         std::to_string(planes.units(1)) + " x " + std::to_string(planes.units(2)) +
                         " units, expected at most " + std::to_string(most_units)};
}

Box box_of(const GridPlanes& planes, const GridCell& cell) {
  Box box;
  for (std::size_t a = 0; a < 3; ++a) {
    box.low[a] = planes.at(a, cell.low[a]);
    box.high[a] = planes.at(a, cell.end[a]);
  }
  return box;
}

std::optional<base::Error> add_openings(CellComplexBuilder& builder, const GridSpace& space,
                                        const GridCells& cells, const GridOptions& options) {
  const GridPlanes& planes = space.planes();
  GridOpenings openings(space, options.most_units);
  std::optional<base::Error> fault;
  cells.for_each_meeting([&](CellNumber below, std::size_t axis, CellNumber above) {
    if (fault) return;
    const auto free = openings.between(cells.cells()[below], cells.cells()[above], axis);
    if (!free) {
      fault = base::Error{
          "", axis_name(axis) + " = " + std::to_string(planes.at(axis, cells.cells()[below].end[axis])),
          "the outlines of sheets cut one rectangle into more than " + std::to_string(options.most_units) +
              " parts"};
      return;
    }
    for (const Rectangle& opening : *free) add_rectangle_opening(builder, opening, below, above);
  });
  for (CellNumber c = 0; c < cells.cells().size(); ++c)
    add_openings_outside(builder, c, box_of(planes, cells.cells()[c]));
  return fault;
}

// Calls visit(cell, low, high) for each part, on a cell's closure, of the span from..to on `axis`, at `point`
// on the other two axes. These parts lie in the up to four rows of units around the line. If a cell has
// several of these rows, only the first counts.
template <class Visit>
void for_each_part(const GridPlanes& planes, const GridCells& cells, std::size_t axis, const PolyPoint& point,
                   const geometry::Span& span, Visit visit) {
  std::array<GridUnit, 4> rows{};
  std::size_t row_count = 0;
  const auto [b, c] = geometry::other_axes(axis);
  const std::array<std::uint32_t, 2> at_b{planes.unit_below(b, point[b]), planes.unit_of(b, point[b])};
  const std::array<std::uint32_t, 2> at_c{planes.unit_below(c, point[c]), planes.unit_of(c, point[c])};
  for (std::size_t j = at_c[0] == at_c[1] ? 1 : 0; j < 2; ++j) {
    for (std::size_t i = at_b[0] == at_b[1] ? 1 : 0; i < 2; ++i) {
      rows[row_count][b] = at_b[i];
      rows[row_count++][c] = at_c[j];
    }
  }
  const std::uint32_t end = planes.unit_below(axis, span.high) + 1;
  for (std::size_t r = 0; r < row_count; ++r) {
    GridUnit unit = rows[r];
    for (unit[axis] = planes.unit_of(axis, span.low); unit[axis] < end;) {
      const CellNumber number = cells.of(unit);
      if (number == GridCells::solid) {
        ++unit[axis];
        continue;
      }
      const GridCell& cell = cells.cells()[number];
      const bool seen = std::any_of(
          rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(r),
          [&, b = b, c = c](const GridUnit& row) { return cell.holds(b, row[b]) && cell.holds(c, row[c]); });
      if (!seen) {
        visit(number, std::max(span.low, planes.at(axis, cell.low[axis])),
              std::min(span.high, planes.at(axis, cell.end[axis])));
      }
      unit[axis] = cell.end[axis];
    }
  }
}

// The edges, in bands of `band_units` units along y, each band ascending. Cells are numbered along x first,
// so cells that touch along y are a whole row apart: without bands, a large building would need more rows
// than fit into the cache.
std::vector<std::uint32_t> edges_in_bands(const CellComplex& complex, const GridPlanes& planes) {
  constexpr std::uint32_t band_units = 64;
  const auto band_of = [&](const ComplexEdge& edge) {
    return planes.unit_of(1, complex.vertices[edge.from][1]) / band_units;
  };
  std::vector<std::uint32_t> next(planes.units(1) / band_units + 2, 0);
  for (const ComplexEdge& edge : complex.edges) ++next[band_of(edge) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<std::uint32_t> order(complex.edges.size());
  for (std::uint32_t e = 0; e < order.size(); ++e) order[next[band_of(complex.edges[e])]++] = e;
  return order;
}

// Calls visit(edge number, axis, cell, low, high) for all edges, in this order.
template <class Visit>
void for_each_line(const CellComplex& complex, std::span<const std::uint32_t> order, const GridPlanes& planes,
                   const GridCells& cells, Visit visit) {
  for (const std::uint32_t e : order) {
    const PolyPoint& from = complex.vertices[complex.edges[e].from];
    const PolyPoint& to = complex.vertices[complex.edges[e].to];
    const std::size_t axis = from[0] != to[0] ? 0 : from[1] != to[1] ? 1 : 2;
    const geometry::Span span{std::min(from[axis], to[axis]), std::max(from[axis], to[axis])};
    for_each_part(planes, cells, axis, from, span, [&](CellNumber cell, std::int32_t low, std::int32_t high) {
      visit(e, axis, cell, low, high);
    });
  }
}

void add_lines(CellComplexBuilder& builder, const GridPlanes& planes, const GridCells& cells) {
  const CellComplex& complex = builder.complex();
  const std::vector<std::uint32_t> order = edges_in_bands(complex, planes);
  std::vector<std::uint32_t> counts(cells.cells().size(), 0);
  for_each_line(complex, order, planes, cells,
                [&](std::uint32_t, std::size_t, CellNumber cell, auto...) { ++counts[cell]; });
  builder.expect_lines(counts);
  for_each_line(complex, order, planes, cells,
                [&](std::uint32_t e, std::size_t axis, CellNumber cell, std::int32_t low, std::int32_t high) {
                  add_axis_line(builder, e, axis, cell, low, high);
                });
}

}  // namespace

std::optional<base::Error> why_no_grid(const PolyScene& scene, const GridOptions& options) {
  if (auto fault = fault_of_faces(scene)) return fault;
  return fault_of_size(GridPlanes(scene, outer_box_of(scene)), options);
}

base::Result<CellComplex> decompose_grid(const PolyScene& scene, const GridOptions& options) {
  if (auto fault = fault_of_faces(scene)) return *fault;
  const Box outer = outer_box_of(scene);
  GridPlanes planes(scene, outer);
  if (auto fault = fault_of_size(planes, options)) return *fault;
  const GridSpace space(scene, std::move(planes));
  const GridCells cells(space);
  CellComplexBuilder builder(scene, outer);
  add_lines(builder, space.planes(), cells);
  builder.reserve(cells.cells().size(), 6 * cells.cells().size());
  builder.reserve_openings(8 * cells.cells().size(), 4 * 8 * cells.cells().size());
  for (const GridCell& cell : cells.cells()) add_box_cell(builder, box_of(space.planes(), cell));
  if (auto fault = add_openings(builder, space, cells, options)) return *fault;
  return builder.take();
}

}  // namespace sightline::scene
