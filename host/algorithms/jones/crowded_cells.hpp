// Index of cells with very many lines or openings, such as the free space around a large building: trees of
// boxes over lines and openings, so that a view reads only those that its mask may meet.
//
// Without them a view from one room through an outer door would look at every line of the wall outside.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "host/geometry/box_tree.hpp"
#include "host/geometry/predicates.hpp"
#include "host/scene/model/cell_complex.hpp"

namespace sightline::algorithms::jones {

struct CrowdedCell {
  geometry::BoxTree lines;     // by place in the cell's lines
  geometry::BoxTree openings;  // by place in the cell's openings
};

class CrowdedCells {
 public:
  // Of so few lines and openings each is looked at sooner than a tree.
  static constexpr std::uint32_t few = 96;

  // `planes` are those of the complex, perhaps divided by a factor.
  CrowdedCells(const scene::CellComplex& complex, std::span<const geometry::Plane> planes);

  // Null for a cell with few.
  [[nodiscard]] const CrowdedCell* find(const scene::CellComplex& complex, scene::CellNumber number) const;

 private:
  std::vector<std::pair<scene::CellNumber, CrowdedCell>> cells_;  // ascending
};

}  // namespace sightline::algorithms::jones
