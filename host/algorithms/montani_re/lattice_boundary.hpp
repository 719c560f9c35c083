// Outlines and holes of lattice stripes, and back to the chains of the paper.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/algorithms/montani_re/lattice_pcs.hpp"

namespace sightline::algorithms::montani_re {

// Corners in half steps, the inside to the left: an outline has a positive area, a hole a negative one.
struct LatticeLoop {
  std::vector<LatticePoint> corners;  // lines that go straight on are joined

  [[nodiscard]] std::int64_t eightfold_area() const;
};

// Loops that only touch are apart. Horizontal pieces are where there is coverage above xor below; the lines
// between stripes are never part of a boundary.
[[nodiscard]] std::vector<LatticeLoop> boundary_of(const LatticePcs& pcs);

struct OwnedChain {
  LatticePoint start;
  std::string links;
};
// In whole steps, from the first corner. Empty if a corner is not a lattice point.
[[nodiscard]] std::optional<OwnedChain> chain_of(const LatticeLoop& loop);

}  // namespace sightline::algorithms::montani_re
