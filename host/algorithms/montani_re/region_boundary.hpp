// Outlines and holes of what is seen of a face, rebuilt from its stripes: the vector output of Montani and Re
// (1985, section 4) in object space, where every corner is a corner of the scene or a crossing of two of its
// edges in the image, exactly.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "host/algorithms/montani_re/image.hpp"
#include "host/algorithms/montani_re/trapezoid_pcs.hpp"

namespace sightline::algorithms::montani_re {

// The point of a line that is not horizontal at an ordinate.
struct RegionCorner {
  std::uint32_t line = 0;
  Ordinate y;
};

// The inside to the left, as the image has it: an outline runs counterclockwise, a hole clockwise. Lines that
// go straight on are joined, so that no corner lies between two others on a line. Where
// several go on from a point, the sharpest turn to the left is taken: parts that only touch are apart, a hole
// that touches its outline is a dent in it.
using RegionLoop = std::vector<RegionCorner>;
[[nodiscard]] std::vector<RegionLoop> boundary_of(const Image& image, const TrapezoidPcs& region);

[[nodiscard]] std::array<double, 2> approximate_point(const Image& image, const RegionCorner& corner);

// Positive for an outline; in floating point, as area() of a region.
[[nodiscard]] double signed_area(const Image& image, const RegionLoop& loop);

// Several faces as one region, as the paper draws a class of equal priority at once: edges they share vanish.
[[nodiscard]] TrapezoidPcs united(const Image& image, std::span<const std::uint32_t> faces,
                                  std::span<const TrapezoidPcs> regions);

}  // namespace sightline::algorithms::montani_re
