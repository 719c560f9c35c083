#include "host/algorithms/jones/start_cells.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "host/geometry/box.hpp"

namespace sightline::algorithms::jones {
namespace {

using scene::CellNumber;

// The connected pieces of free space around the eye, each cell labelled with the position of its piece's first cell in
// `cells`.
std::vector<std::size_t> pieces_of(const PreparedComplex& prepared, const std::vector<CellNumber>& cells,
                                   const geometry::Point3& eye) {
  const scene::CellComplex& complex = prepared.complex();
  std::vector<std::size_t> piece(cells.size());
  std::iota(piece.begin(), piece.end(), std::size_t{0});
  const auto join = [&piece](std::size_t a, std::size_t b) {
    const auto [low, high] = std::minmax(piece[a], piece[b]);
    for (std::size_t& p : piece) {
      if (p == high) p = low;
    }
  };
  const auto has_eye = [&](const scene::ComplexOpening& opening) {
    const auto sides = complex.sides_of(opening);
    return prepared.planes()[opening.plane].side(eye) == 0 &&
           std::all_of(sides.begin(), sides.end(),
                       [&](const scene::HalfSpace& half) { return contains(prepared.planes(), half, eye); });
  };
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (const std::uint32_t number : complex.openings_of(complex.cells[cells[i]])) {
      const scene::ComplexOpening& opening = complex.openings[number];
      const CellNumber other = opening.cells[0] == cells[i] ? opening.cells[1] : opening.cells[0];
      const auto at = std::lower_bound(cells.begin(), cells.end(), other);
      if (at != cells.end() && *at == other && has_eye(opening))
        join(i, static_cast<std::size_t>(at - cells.begin()));
    }
  }
  return piece;
}

// Whether the cell contains a step from the eye along forward, plus a far smaller step to the right and a far smaller one
// up.
bool contains_point_ahead(const PreparedComplex& prepared, CellNumber number, const scene::PolyCamera& camera) {
  const scene::CellComplex& complex = prepared.complex();
  for (const scene::HalfSpace& half : complex.bounds_of(complex.cells[number])) {
    const geometry::Plane& plane = prepared.planes()[half.plane];
    if (plane.side(camera.eye) != 0) continue;
    std::int64_t step = 0;
    for (const scene::PolyPoint* direction : {&camera.forward, &camera.right, &camera.up}) {
      if (step == 0) step = geometry::dot(plane.normal, geometry::vector_of(*direction));
    }
    if (half.turned ? step < 0 : step > 0) return false;
  }
  return true;
}

std::vector<CellNumber> cells_around_eye(const PreparedComplex& prepared, const scene::PolyCamera& camera) {
  std::vector<CellNumber> cells = prepared.cells_at(camera.eye);
  if (cells.size() < 2) return cells;
  const std::vector<std::size_t> piece = pieces_of(prepared, cells, camera.eye);
  std::size_t chosen = 0;
  for (std::size_t i = cells.size(); i-- > 0;) {
    if (contains_point_ahead(prepared, cells[i], camera)) chosen = piece[i];
  }
  std::vector<CellNumber> start;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (piece[i] == chosen) start.push_back(cells[i]);
  }
  return start;
}

}  // namespace

std::optional<Start> find_start(const PreparedComplex& prepared, const scene::PolyCamera& camera) {
  if (!camera.perspective) return Start{true, {}};
  Start start{!prepared.complex().outer.contains_inside(camera.eye), cells_around_eye(prepared, camera)};
  if (!start.outside && start.cells.empty()) return std::nullopt;
  return start;
}

}  // namespace sightline::algorithms::jones
