#include "host/algorithms/jones/crowded_cells.hpp"

#include <algorithm>

#include "host/algorithms/jones/enclosing_box.hpp"

namespace sightline::algorithms::jones {
namespace {

using geometry::Box;

bool is_crowded(const scene::ComplexCell& cell) {
  return cell.line_count + cell.opening_count > CrowdedCells::few;
}

// The box of the whole edge, which may be longer than the line.
Box box_of_edge(const scene::CellComplex& complex, const scene::ComplexEdge& edge) {
  const scene::PolyPoint& from = complex.vertices[edge.from];
  const scene::PolyPoint& to = complex.vertices[edge.to];
  Box box;
  for (std::size_t a = 0; a < 3; ++a) {
    box.low[a] = std::min(from[a], to[a]);
    box.high[a] = std::max(from[a], to[a]);
  }
  return box;
}

std::vector<Box> boxes_of_lines(const scene::CellComplex& complex, const scene::ComplexCell& cell) {
  std::vector<Box> boxes;
  for (const scene::ComplexLine line : complex.lines_of(cell))
    boxes.push_back(box_of_edge(complex, complex.edges[line.edge]));
  return boxes;
}

std::vector<Box> boxes_of_openings(const scene::CellComplex& complex, const scene::ComplexCell& cell,
                                   std::span<const geometry::Plane> planes) {
  std::vector<Box> boxes;
  std::vector<scene::HalfSpace> halves;
  for (const std::uint32_t number : complex.openings_of(cell)) {
    const scene::ComplexOpening& opening = complex.openings[number];
    const auto sides = complex.sides_of(opening);
    halves.assign(sides.begin(), sides.end());
    halves.push_back({opening.plane, false});
    halves.push_back({opening.plane, true});
    boxes.push_back(enclosing_box(complex.outer, planes, halves));
  }
  return boxes;
}

}  // namespace

CrowdedCells::CrowdedCells(const scene::CellComplex& complex, std::span<const geometry::Plane> planes) {
  for (std::size_t c = 0; c < complex.cells.size(); ++c) {
    const scene::ComplexCell& cell = complex.cells[c];
    if (!is_crowded(cell)) continue;
    cells_.emplace_back(static_cast<scene::CellNumber>(c),
                        CrowdedCell{geometry::BoxTree(boxes_of_lines(complex, cell)),
                                    geometry::BoxTree(boxes_of_openings(complex, cell, planes))});
  }
}

const CrowdedCell* CrowdedCells::find(const scene::CellComplex& complex, scene::CellNumber number) const {
  if (!is_crowded(complex.cells[number])) return nullptr;
  const auto found = std::lower_bound(cells_.begin(), cells_.end(), number,
                                      [](const auto& cell, scene::CellNumber n) { return cell.first < n; });
  return &found->second;
}

}  // namespace sightline::algorithms::jones
