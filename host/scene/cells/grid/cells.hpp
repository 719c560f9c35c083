// The boxes that decompose_grid grows in its grid, and which of them touch.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "host/scene/cells/grid/space.hpp"
#include "host/scene/model/cell_complex.hpp"

namespace sightline::scene {

// Units low..end - 1 on each axis.
struct GridCell {
  GridUnit low{};
  GridUnit end{};

  [[nodiscard]] bool holds(std::size_t axis, std::uint32_t n) const {
    return low[axis] <= n && n < end[axis];
  }
};

class GridCells {
 public:
  static constexpr CellNumber solid = outside;

  explicit GridCells(const GridSpace& space);

  [[nodiscard]] const std::vector<GridCell>& cells() const { return cells_; }
  // The cell of a unit; `solid` if it is in none.
  [[nodiscard]] CellNumber of(std::size_t unit) const { return owner_[unit]; }
  [[nodiscard]] CellNumber of(const GridUnit& unit) const { return owner_[space_.index(unit)]; }
  // Calls visit(cell, axis, other) where `other` lies on the high side of `cell` and the two share an area of
  // the plane where `cell` ends on `axis`. Ascending by cell, then axis; every pair and axis once.
  template <class Visit>
  void for_each_meeting(Visit visit) const;

 private:
  static constexpr CellNumber free = outside - 1;

  [[nodiscard]] bool slab_is_free(const GridCell& cell, std::size_t axis) const;

  const GridSpace& space_;
  std::vector<CellNumber> owner_;
  std::vector<GridCell> cells_;
};

// A pair is found at the lowest unit of the rectangle that it shares.
template <class Visit>
void GridCells::for_each_meeting(Visit visit) const {
  for (CellNumber c = 0; c < cells_.size(); ++c) {
    const GridCell& cell = cells_[c];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (cell.end[axis] == space_.planes().units(axis)) continue;
      const auto [u, v] = geometry::other_axes(axis);
      GridUnit unit{};
      unit[axis] = cell.end[axis];
      for (unit[v] = cell.low[v]; unit[v] < cell.end[v]; ++unit[v]) {
        for (unit[u] = cell.low[u]; unit[u] < cell.end[u];) {
          const CellNumber other = of(unit);
          if (other == solid) {
            ++unit[u];
            continue;
          }
          const GridCell& beyond = cells_[other];
          if (unit[v] == cell.low[v] || unit[v] == beyond.low[v]) visit(c, axis, other);
          unit[u] = beyond.end[u];
        }
      }
    }
  }
}

}  // namespace sightline::scene
