// The chains of a view for the column oracle, made from the projected points and their depths alone, not from any
// order, chain or stream of the host's. Grids without holes and views without zoom only.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

#include "host/algorithms/oracle/column_oracle.hpp"
#include "host/programs/skala/contours.hpp"
#include "host/programs/skala/projection.hpp"

namespace sightline::compare {

class ViewChains {
 public:
  using Chain = algorithms::oracle::Chain;
  using ChainVertex = algorithms::oracle::ChainVertex;
  using SegmentRole = algorithms::oracle::SegmentRole;

  explicit ViewChains(const programs::skala::Projection& projection)
      : projection_(projection),
        sine_(projection.rotation().sine),
        cosine_(projection.rotation().cosine),
        slices_along_x_(std::abs(cosine_) >= std::abs(sine_)) {}

  // The greatest difference of depth between two points of slices of the same exact depth once their columns are
  // rounded: the depth of a column along a direction that is at most 45 degrees from the image plane.
  [[nodiscard]] std::int64_t slice_tolerance() const { return quantise(column_width()); }
  // The same for cells, whose edges may be seen end-on; at most the depth of a cell.
  [[nodiscard]] std::int64_t cell_tolerance() const {
    const double flat = std::min(std::abs(sine_), std::abs(cosine_));
    const double cell = 2.0 / std::max({points() - 1, slice_count() - 1, 1});
    return quantise(flat * cell > column_width() ? column_width() / flat : cell);
  }

  // Slices along the axis that is less end-on. The nearest chain is the nearest slice with the grid's side edge on
  // the side where farther slices extend beyond nearer ones.
  [[nodiscard]] std::vector<Chain> slices(SegmentRole slice_role, SegmentRole rim_role) const {
    const bool leading_is_right = right_end(rows() - 1) >= right_end(0);
    const auto nearest = line(row_place(0, 0), row_place(0, columns() - 1), slice_role);
    const auto leading = rim(leading_is_right, rim_role);
    std::vector<Chain> chains{
        {0, leading_is_right ? join(nearest, leading) : join(reverse(leading), nearest)}};
    for (int row = 1; row < rows(); ++row)
      chains.push_back({row, line(row_place(row, 0), row_place(row, columns() - 1), slice_role)});
    chains.push_back({rows(), rim(!leading_is_right, slice_role)});
    return chains;
  }

  // The far margins of all cells, each hiding the chains that follow; the near margins of the domain first.
  [[nodiscard]] std::vector<Chain> cells() const {
    std::vector<Chain> chains{near_margins()};
    for_cells([&](const Cell& cell, int rank) {
      chains.push_back({rank, far_margins(cell, SegmentRole::draw)});
    });
    return chains;
  }

  // Contour pieces triangle by triangle, with the cells' diagonals and far margins. Only the domain's edges are
  // inked.
  [[nodiscard]] std::vector<Chain> contours(const scene::HeightGrid& grid, int level_count) const {
    const auto levels = programs::skala::contour_levels(grid.range, level_count);
    std::vector<Chain> chains{near_margins()};
    for_cells([&](const Cell& cell, int rank) {
      pieces(chains, grid, levels, {cell.nearest, cell.left, cell.right}, rank);
      chains.push_back({rank + 1, line(cell.left, cell.right, SegmentRole::mask)});
      pieces(chains, grid, levels, {cell.left, cell.farthest, cell.right}, rank + 2);
      chains.push_back({rank + 3, far_margins(cell, SegmentRole::mask)});
    });
    return chains;
  }

 private:
  struct Cell {
    programs::skala::GridIndex nearest, left, right, farthest;
    bool last_along_x = false;  // the edge farthest along x is the domain's
    bool last_along_z = false;
  };

  [[nodiscard]] static std::int64_t quantise(double depth) {
    return static_cast<std::int64_t>(std::llround(std::ldexp(depth, 24)));
  }
  [[nodiscard]] const programs::skala::Vertex& at(programs::skala::GridIndex index) const {
    return projection_.at(index.point, index.slice);
  }
  [[nodiscard]] static ChainVertex vertex(const programs::skala::Vertex& point, SegmentRole role) {
    return {point.column, point.row, quantise(point.depth), role};
  }
  [[nodiscard]] ChainVertex vertex(programs::skala::GridIndex index, SegmentRole role) const {
    return vertex(at(index), role);
  }

  // The width of a raster column in the grid's units: the picture is 2 |cos A| + 2 |sin A| wide.
  [[nodiscard]] double column_width() const { return 2 * (std::abs(cosine_) + std::abs(sine_)) / 255; }

  // Steps away from the eye: depth is z cos A - x sin A.
  [[nodiscard]] bool z_away() const { return cosine_ >= 0; }
  [[nodiscard]] bool x_away() const { return sine_ <= 0; }
  [[nodiscard]] programs::skala::GridIndex from_eye(int point, int slice) const {
    return {static_cast<std::size_t>(x_away() ? point : points() - 1 - point),
            static_cast<std::size_t>(z_away() ? slice : slice_count() - 1 - slice)};
  }
  [[nodiscard]] int points() const { return static_cast<int>(projection_.points()); }
  [[nodiscard]] int slice_count() const { return static_cast<int>(projection_.slices()); }

  // Rows are slices from near to far, columns go from left to right on the screen.
  [[nodiscard]] int rows() const { return slices_along_x_ ? slice_count() : points(); }
  [[nodiscard]] int columns() const { return slices_along_x_ ? points() : slice_count(); }
  [[nodiscard]] programs::skala::GridIndex row_place(int row, int column) const {
    const bool to_the_right = slices_along_x_ ? cosine_ > 0 : sine_ > 0;  // screen x is x cos A + z sin A
    const auto across = static_cast<std::size_t>(to_the_right ? column : columns() - 1 - column);
    if (slices_along_x_) return {across, from_eye(0, row).slice};
    return {from_eye(row, 0).point, across};
  }
  [[nodiscard]] double right_end(int row) const { return at(row_place(row, columns() - 1)).x; }

  // From near to far.
  [[nodiscard]] std::vector<ChainVertex> rim(bool right, SegmentRole role) const {
    std::vector<ChainVertex> vertices;
    for (int row = 0; row < rows(); ++row)
      vertices.push_back(vertex(row_place(row, right ? columns() - 1 : 0), role));
    vertices.front().role = SegmentRole::none;
    return vertices;
  }
  // All grid points from one to the other, which share a row or a column; or the segment between two corners of a
  // cell.
  [[nodiscard]] std::vector<ChainVertex> line(programs::skala::GridIndex from, programs::skala::GridIndex to,
                                              SegmentRole role) const {
    const auto towards = [](std::size_t a, std::size_t b) { return a < b ? a + 1 : a > b ? a - 1 : a; };
    std::vector<ChainVertex> vertices{vertex(from, SegmentRole::none)};
    if (from == to) vertices.push_back(vertex(from, role));  // a dot
    while (from != to) {
      from = {towards(from.point, to.point), towards(from.slice, to.slice)};
      vertices.push_back(vertex(from, role));
    }
    return vertices;
  }
  [[nodiscard]] static std::vector<ChainVertex> reverse(std::vector<ChainVertex> vertices) {
    std::reverse(vertices.begin(), vertices.end());
    if (vertices.size() > 1) std::swap(vertices.front().role, vertices.back().role);
    return vertices;
  }
  [[nodiscard]] static std::vector<ChainVertex> join(std::vector<ChainVertex> first,
                                                       const std::vector<ChainVertex>& second) {
    first.insert(first.end(), second.begin() + 1, second.end());
    return first;
  }

  [[nodiscard]] Chain near_margins() const {
    const programs::skala::GridIndex corner = from_eye(0, 0);
    return {-1, join(reverse(line(corner, from_eye(points() - 1, 0), SegmentRole::draw)),
                       line(corner, from_eye(0, slice_count() - 1), SegmentRole::draw))};
  }

  // Visits cells away from the eye in both directions. The ranks of a cell's chains are that of the call and the
  // three after it.
  template <class Visit>
  void for_cells(Visit&& visit) const {
    int rank = 0;
    for (int slice = 0; slice + 1 < slice_count(); ++slice) {
      for (int point = 0; point + 1 < points(); ++point, rank += 4)
        visit(Cell{from_eye(point, slice), from_eye(point + 1, slice), from_eye(point, slice + 1),
                   from_eye(point + 1, slice + 1), point + 2 == points(), slice + 2 == slice_count()},
              rank);
    }
  }
  [[nodiscard]] std::vector<ChainVertex> far_margins(const Cell& cell, SegmentRole inner) const {
    const SegmentRole along_z = cell.last_along_x ? SegmentRole::draw : inner;
    const SegmentRole along_x = cell.last_along_z ? SegmentRole::draw : inner;
    return {vertex(cell.left, SegmentRole::none), vertex(cell.farthest, along_z),
            vertex(cell.right, along_x)};
  }
  [[nodiscard]] algorithms::oracle::ColumnExtent columns_of(
      const std::array<programs::skala::GridIndex, 3>& triangle) const {
    const auto [first, last] =
        std::minmax({at(triangle[0]).column, at(triangle[1]).column, at(triangle[2]).column});
    return {first, last};
  }
  void pieces(std::vector<Chain>& chains, const scene::HeightGrid& grid, const std::vector<double>& levels,
              const std::array<programs::skala::GridIndex, 3>& triangle, int rank) const {
    for (const double level : levels) {
      const auto crossing = programs::skala::contour_crossing(grid, projection_, triangle, level);
      if (!crossing.crossed) continue;
      const auto& [from, to] = crossing.piece;
      if (from.column == to.column && from.row == to.row) continue;
      chains.push_back(
          {rank, {vertex(from, SegmentRole::none), vertex(to, SegmentRole::test)}, columns_of(triangle)});
    }
  }

  const programs::skala::Projection& projection_;
  double sine_;
  double cosine_;
  bool slices_along_x_;
};

}  // namespace sightline::compare
