// Rebuilds the outlines and holes of a face's visible region from its stripes: the vector output of Montani and Re (1985,
// section 4) in object space. Every corner is exactly a corner of the scene or a crossing of the images of two of its
// edges.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "host/algorithms/montani_re/image.hpp"
#include "host/algorithms/montani_re/trapezoid_pcs.hpp"

namespace sightline::algorithms::montani_re {

// A point given by its ordinate and a line through it that is not horizontal.
struct RegionCorner {
  std::uint32_t line = 0;
  Ordinate y;
};

// The inside is to the left: in the image, an outline runs counterclockwise, a hole clockwise. Collinear pieces are
// joined, so that no corner lies on the line between its neighbours. Where several pieces leave a point, the sharpest
// left turn is taken: parts that only touch are separate, and a hole that touches its outline becomes part of it.
using RegionLoop = std::vector<RegionCorner>;
[[nodiscard]] std::vector<RegionLoop> boundary_of(const Image& image, const TrapezoidPcs& region);

[[nodiscard]] std::array<double, 2> approximate_point(const Image& image, const RegionCorner& corner);

// Positive for an outline. In floating point, like area() of a region.
[[nodiscard]] double signed_area(const Image& image, const RegionLoop& loop);

// The union of several faces, as the paper draws a class of equal priority at once: shared edges vanish.
[[nodiscard]] TrapezoidPcs unite_regions(const Image& image, std::span<const std::uint32_t> faces,
                                  std::span<const TrapezoidPcs> regions);

}  // namespace sightline::algorithms::montani_re
