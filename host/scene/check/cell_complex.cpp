// See cell_complex.hpp: the order of questions, and those about numbers and lines.
#include "host/scene/check/cell_complex.hpp"

#include <algorithm>
#include <string>

#include "host/base/result.hpp"
#include "host/scene/cells/builder.hpp"
#include "host/scene/check/cell_complex_parts.hpp"
#include "host/scene/check/problems.hpp"

namespace sightline::scene {
namespace {

bool within(std::uint32_t first, std::uint32_t count, std::size_t size) {
  return std::size_t{first} + count <= size;
}

bool has_planes(const CellComplex& complex, const std::vector<HalfSpace>& halves) {
  return std::all_of(halves.begin(), halves.end(),
                     [&](const HalfSpace& half) { return half.plane < complex.planes.size(); });
}

void check_rows(const CellComplex& complex, Problems& problems) {
  for (std::size_t c = 0; c < complex.cells.size() && !problems.full(); ++c) {
    const ComplexCell& cell = complex.cells[c];
    if (!within(cell.first_bound, cell.bound_count, complex.bounds.size()) ||
        !within(cell.first_line, cell.line_count, complex.lines.size()) ||
        !within(cell.first_opening, cell.opening_count, complex.opening_numbers.size())) {
      problems.add("cell", c, "its rows go beyond the end of bounds, lines or openings");
    }
  }
  for (std::size_t o = 0; o < complex.openings.size() && !problems.full(); ++o) {
    const ComplexOpening& opening = complex.openings[o];
    if (opening.plane >= complex.planes.size() ||
        !within(opening.first_side, opening.side_count, complex.sides.size())) {
      problems.add("opening", o, "its plane or sides are beyond the end of planes or sides");
    }
    for (const CellNumber cell : opening.cells)
      if (cell != outside && cell >= complex.cells.size())
        problems.add("opening", o, "found cell " + std::to_string(cell) + ", which is not there");
    if (opening.cells[0] == opening.cells[1]) problems.add("opening", o, "has the same cell on both sides");
  }
}

void check_lists(const CellComplex& complex, Problems& problems) {
  std::size_t listed = 0;
  for (std::size_t c = 0; c < complex.cells.size() && !problems.full(); ++c) {
    const auto openings = complex.openings_of(complex.cells[c]);
    listed += openings.size();
    for (std::size_t i = 0; i < openings.size(); ++i) {
      const auto& sides = complex.openings[openings[i]].cells;
      if (i > 0 && openings[i - 1] >= openings[i]) problems.add("cell", c, "its openings do not ascend");
      if (sides[0] != c && sides[1] != c)
        problems.add("cell", c, "lists opening " + std::to_string(openings[i]) + " of other cells");
    }
  }
  std::size_t expected = 0;
  for (const ComplexOpening& opening : complex.openings)
    for (const CellNumber cell : opening.cells) expected += cell != outside ? 1U : 0U;
  if (listed < expected)
    problems.add("openings",
                 "found " + std::to_string(listed) + " by cell, expected " + std::to_string(expected));
}

}  // namespace

void check_complex_numbers(const CellComplex& complex, const PolyScene& scene, Problems& problems) {
  if (complex.vertices != scene.vertices) problems.add("vertices", "are not those of the scene");
  if (complex.edges != complex_edges_of(scene)) problems.add("edges", "are not those of the scene");
  if (!has_planes(complex, complex.bounds)) problems.add("bounds", "name a plane that is not there");
  if (!has_planes(complex, complex.sides)) problems.add("sides", "name a plane that is not there");
  for (std::size_t p = 0; p < complex.planes.size(); ++p)
    if (geometry::is_zero(complex.planes[p].normal)) problems.add("plane", p, "has no normal");
  for (const std::uint32_t number : complex.opening_numbers)
    if (number >= complex.openings.size())
      problems.add("opening_numbers", "found " + std::to_string(number) + ", which is not there");
  for (const ComplexLine line : complex.lines)
    if (line.edge >= complex.edges.size())
      problems.add("lines", "found edge " + std::to_string(line.edge) + ", which is not there");
  check_rows(complex, problems);
  if (problems.none()) check_lists(complex, problems);
}

// An end of a line is on the side of a plane of q a + p (b - a), where the end is from + p/q (to - from): 60
// bits over 60 at most.
void check_complex_lines(const CellComplex& complex, Problems& problems) {
  const auto beyond = [&](const HalfSpace& half, const ComplexEdge& edge, const geometry::Rational& end) {
    const geometry::Plane& plane = complex.planes[half.plane];
    const PolyPoint& from = complex.vertices[edge.from];
    const std::int64_t slope =
        geometry::dot(plane.normal, geometry::difference(complex.vertices[edge.to], from));
    const geometry::Int128 at =
        geometry::Int128{plane.at(from)} * end.denominator() + geometry::Int128{slope} * end.numerator();
    return half.turned ? at < 0 : at > 0;
  };
  for (std::size_t c = 0; c < complex.cells.size() && !problems.full(); ++c) {
    for (const ComplexLine line : complex.lines_of(complex.cells[c])) {
      const std::string name = "its line on edge " + std::to_string(line.edge);
      if (!(geometry::Rational(0) <= line.low && line.low < line.high &&
            line.high <= geometry::Rational(1))) {
        problems.add("cell", c, name + " is no part of the edge");
        continue;
      }
      for (const HalfSpace& half : complex.bounds_of(complex.cells[c])) {
        const ComplexEdge& edge = complex.edges[line.edge];
        if (beyond(half, edge, line.low) || beyond(half, edge, line.high))
          problems.add("cell", c, name + " leaves the cell");
      }
    }
  }
}

std::vector<base::Error> check_complex(const CellComplex& complex, const PolyScene& scene,
                                       std::uint64_t seed) {
  Problems problems;
  check_complex_numbers(complex, scene, problems);
  if (!problems.none()) return problems.take();
  check_complex_openings(complex, problems);
  check_complex_cells(complex, problems);
  check_complex_lines(complex, problems);
  if (!problems.none()) return problems.take();
  check_complex_volume(complex, scene, problems);
  check_complex_places(complex, scene, seed, problems);
  return problems.take();
}

}  // namespace sightline::scene
