// See builder.hpp.
#include "host/scene/cells/builder.hpp"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

namespace sightline::scene {
namespace {

constexpr std::uint32_t no_plane = std::numeric_limits<std::uint32_t>::max();

template <class Visit>
void for_each_side(const PolyScene& scene, Visit visit) {
  const auto ring_sides = [&](std::span<const VertexIndex> ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const VertexIndex a = ring[i];
      const VertexIndex b = ring[i + 1 == ring.size() ? 0 : i + 1];
      if (a != b) visit(std::min(a, b), std::max(a, b));
    }
  };
  for (const PolyBody& body : scene.bodies) {
    for (const PolyFace& face : body.faces) {
      ring_sides(face.outline);
      for (const auto& hole : face.holes) ring_sides(hole);
    }
  }
  for (const auto& [a, b] : scene.wires) visit(std::min(a, b), std::max(a, b));
}

// The plane in lowest terms with its first nonzero component positive, and whether its sign was changed for
// that.
std::pair<geometry::Plane, bool> canonical(const geometry::Plane& plane) {
  assert(!geometry::is_zero(plane.normal));
  std::int64_t divisor = plane.offset;
  for (const std::int64_t component : plane.normal) divisor = std::gcd(divisor, component);
  const auto* const first =
      std::find_if(plane.normal.begin(), plane.normal.end(), [](std::int64_t c) { return c != 0; });
  const bool turned = *first < 0;
  if (turned) divisor = -divisor;
  return {{{plane.normal[0] / divisor, plane.normal[1] / divisor, plane.normal[2] / divisor},
           plane.offset / divisor},
          turned};
}

}  // namespace

geometry::Box outer_box_of(const PolyScene& scene) {
  assert(!scene.vertices.empty());
  geometry::Box box{scene.vertices[0], scene.vertices[0]};
  for (const PolyPoint& p : scene.vertices) {
    for (std::size_t a = 0; a < 3; ++a) {
      box.low[a] = std::min(box.low[a], p[a]);
      box.high[a] = std::max(box.high[a], p[a]);
    }
  }
  for (std::size_t a = 0; a < 3; ++a) {
    --box.low[a];
    ++box.high[a];
  }
  return box;
}

// A counting sort by the lower vertex, which few edges share, leaves only short runs to sort. Then
// repetitions are removed from each run.
std::vector<ComplexEdge> complex_edges_of(const PolyScene& scene) {
  std::vector<std::uint32_t> next(scene.vertices.size() + 1, 0);  // by vertex, where its next edge goes
  for_each_side(scene, [&](VertexIndex from, VertexIndex) { ++next[from + 1]; });
  for (std::size_t v = 1; v < next.size(); ++v) next[v] += next[v - 1];
  std::vector<ComplexEdge> edges(next.back());
  for_each_side(scene, [&](VertexIndex from, VertexIndex to) { edges[next[from]++] = {from, to}; });
  const auto place = [&](std::size_t i) { return edges.begin() + static_cast<std::ptrdiff_t>(i); };
  auto kept = edges.begin();
  std::size_t first = 0;
  for (std::size_t v = 0; v + 1 < next.size(); first = next[v++]) {
    std::sort(place(first), place(next[v]),
              [](const ComplexEdge& a, const ComplexEdge& b) { return a.to < b.to; });
    for (auto edge = place(first); edge != place(next[v]); ++edge)
      if (edge == place(first) || edge->to != std::prev(kept)->to) *kept++ = *edge;
  }
  edges.erase(kept, edges.end());
  edges.shrink_to_fit();
  return edges;
}

std::size_t CellComplexBuilder::PlaneHash::operator()(const geometry::Plane& plane) const {
  auto hash = static_cast<std::uint64_t>(plane.offset);
  for (const std::int64_t component : plane.normal) {
    hash = (hash ^ (hash >> 31)) * 0x9E3779B97F4A7C15U + static_cast<std::uint64_t>(component);
  }
  return static_cast<std::size_t>(hash ^ (hash >> 29));
}

CellComplexBuilder::CellComplexBuilder(const PolyScene& scene, const geometry::Box& outer) {
  complex_.outer = outer;
  complex_.vertices = scene.vertices;
  complex_.edges = complex_edges_of(scene);
  for (std::size_t a = 0; a < 3; ++a) {
    axis_planes_[a].assign(static_cast<std::size_t>(outer.span(a).length() + 1), no_plane);
  }
}

std::uint32_t CellComplexBuilder::new_plane(const geometry::Plane& plane) {
  complex_.planes.push_back(plane);
  return static_cast<std::uint32_t>(complex_.planes.size() - 1);
}

std::uint32_t CellComplexBuilder::axis_plane(std::size_t axis, std::int32_t at) {
  assert(complex_.outer.span(axis).contains(at));
  std::uint32_t& number = axis_planes_[axis][static_cast<std::size_t>(at - complex_.outer.low[axis])];
  if (number == no_plane) {
    geometry::Plane plane;
    plane.normal[axis] = 1;
    plane.offset = at;
    number = new_plane(plane);
  }
  return number;
}

HalfSpace CellComplexBuilder::behind(const geometry::Plane& plane) {
  const auto [lowest, turned] = canonical(plane);
  for (std::size_t a = 0; a < 3; ++a) {
    const bool parallel =
        lowest.normal[a] == 1 && lowest.normal[(a + 1) % 3] == 0 && lowest.normal[(a + 2) % 3] == 0;
    if (parallel) return {axis_plane(a, static_cast<std::int32_t>(lowest.offset)), turned};
  }
  const auto [known, is_new] = slanted_planes_.try_emplace(lowest, no_plane);
  if (is_new) known->second = new_plane(lowest);
  return {known->second, turned};
}

CellNumber CellComplexBuilder::add_cell(std::span<const HalfSpace> bounds) {
  assert(complex_.cells.size() < outside);
  ComplexCell cell;
  cell.first_bound = static_cast<std::uint32_t>(complex_.bounds.size());
  cell.bound_count = static_cast<std::uint32_t>(bounds.size());
  complex_.bounds.insert(complex_.bounds.end(), bounds.begin(), bounds.end());
  complex_.cells.push_back(cell);
  return static_cast<CellNumber>(complex_.cells.size() - 1);
}

void CellComplexBuilder::add_opening(const HalfSpace& near, CellNumber within, CellNumber beyond,
                                     std::span<const HalfSpace> sides) {
  assert(within != beyond);
  ComplexOpening opening;
  opening.plane = near.plane;
  opening.first_side = static_cast<std::uint32_t>(complex_.sides.size());
  opening.side_count = static_cast<std::uint32_t>(sides.size());
  if (near.turned) {
    opening.cells = {beyond, within};
    complex_.sides.insert(complex_.sides.end(), sides.rbegin(), sides.rend());
  } else {
    opening.cells = {within, beyond};
    complex_.sides.insert(complex_.sides.end(), sides.begin(), sides.end());
  }
  complex_.openings.push_back(opening);
}

void CellComplexBuilder::add_line(CellNumber cell, std::uint32_t edge, const geometry::Rational& low,
                                  const geometry::Rational& high) {
  assert(low < high);
  if (next_lines_.empty()) {
    complex_.lines.push_back({edge, low, high});
    line_cells_.push_back(cell);
  } else {
    complex_.lines.set(next_lines_[cell]++, {edge, low, high});
  }
}

void CellComplexBuilder::expect_lines(const std::vector<std::uint32_t>& count_by_cell) {
  assert(complex_.lines.empty());
  next_lines_.reserve(count_by_cell.size());
  std::uint32_t first = 0;
  for (const std::uint32_t count : count_by_cell) {
    next_lines_.push_back(first);
    first += count;
  }
  complex_.lines.resize(first);
}

void CellComplexBuilder::reserve(std::size_t cells, std::size_t bounds) {
  complex_.cells.reserve(cells);
  complex_.bounds.reserve(bounds);
}

void CellComplexBuilder::reserve_openings(std::size_t openings, std::size_t sides) {
  complex_.openings.reserve(openings);
  complex_.sides.reserve(sides);
}

// All expected lines have been added, so a cell's lines end where its next one would go.
void CellComplexBuilder::find_expected_lines() {
  assert(next_lines_.size() == complex_.cells.size());
  std::uint32_t first = 0;
  for (std::size_t c = 0; c < complex_.cells.size(); ++c) {
    complex_.cells[c].first_line = first;
    complex_.cells[c].line_count = next_lines_[c] - first;
    complex_.lines.sort_by_edge(first, next_lines_[c]);
    first = next_lines_[c];
  }
}

// Sorts in place, along the cycles of the permutation.
void CellComplexBuilder::sort_lines() {
  for (const CellNumber cell : line_cells_) ++complex_.cells[cell].line_count;
  std::uint32_t first = 0;
  for (ComplexCell& cell : complex_.cells) {
    cell.first_line = first;
    first += cell.line_count;
  }
  std::vector<std::uint32_t> next(complex_.cells.size());
  for (std::size_t c = 0; c < next.size(); ++c) next[c] = complex_.cells[c].first_line;
  std::vector<std::uint32_t>& target = line_cells_;
  for (std::uint32_t& line : target) line = next[line]++;
  for (std::uint32_t i = 0; i < target.size(); ++i) {
    while (target[i] != i) {
      const std::uint32_t to = target[i];
      complex_.lines.swap(i, to);
      std::swap(target[i], target[to]);
    }
  }
}

void CellComplexBuilder::list_openings() {
  const auto for_each_cell = [&](const ComplexOpening& opening, auto visit) {
    for (const CellNumber cell : opening.cells)
      if (cell != outside) visit(complex_.cells[cell]);
  };
  for (const ComplexOpening& opening : complex_.openings)
    for_each_cell(opening, [](ComplexCell& cell) { ++cell.opening_count; });
  std::uint32_t first = 0;
  for (ComplexCell& cell : complex_.cells) {
    cell.first_opening = first;
    first += cell.opening_count;
    cell.opening_count = 0;
  }
  complex_.opening_numbers.resize(first);
  for (std::uint32_t o = 0; o < complex_.openings.size(); ++o) {
    for_each_cell(complex_.openings[o], [&](ComplexCell& cell) {
      complex_.opening_numbers[cell.first_opening + cell.opening_count++] = o;
    });
  }
}

CellComplex CellComplexBuilder::take() {
  next_lines_.empty() ? sort_lines() : find_expected_lines();
  list_openings();
  return std::move(complex_);
}

}  // namespace sightline::scene
