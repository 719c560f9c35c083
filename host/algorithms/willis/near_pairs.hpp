// Finds pairs of boxes that are near each other, using a uniform grid.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "host/algorithms/willis/surface.hpp"

namespace sightline::algorithms::willis {

// A box, and the square of the distance that its boundary reaches beyond it, in lattice units.
struct ReachingBox {
  Point low{};
  Point high{};
  std::uint64_t squared_reach = 0;
};

[[nodiscard]] ReachingBox box_of(const Surface& s);

// Whether the boxes are within the reach of either.
[[nodiscard]] bool near_each_other(const ReachingBox& a, const ReachingBox& b);

using NumberPair = std::pair<std::uint32_t, std::uint32_t>;  // first < second

// All pairs that are near each other, ascending.
[[nodiscard]] std::vector<NumberPair> near_pairs(std::span<const ReachingBox> boxes);

}  // namespace sightline::algorithms::willis
