// An index of cells with very many lines or openings, such as the free space around a large building: box trees over
// lines and openings, so that a view reads only those that its mask may meet.
//
// Without it, a view out of a door would test every line of the outer wall.
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
  geometry::BoxTree lines;     // numbers: positions in the cell's lines
  geometry::BoxTree openings;  // numbers: positions in the cell's openings
};

class CrowdedCells {
 public:
  // Up to this number of lines and openings, testing each one is faster than searching a tree.
  static constexpr std::uint32_t few = 96;

  // `planes` are those of the complex; each may be divided by a factor.
  CrowdedCells(const scene::CellComplex& complex, std::span<const geometry::Plane> planes);

  // Null if the cell is not crowded.
  [[nodiscard]] const CrowdedCell* find(const scene::CellComplex& complex, scene::CellNumber number) const;

 private:
  std::vector<std::pair<scene::CellNumber, CrowdedCell>> cells_;  // ascending
};

}  // namespace sightline::algorithms::jones
