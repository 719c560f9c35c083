// Antialiasing by the sides of stripes: how much of each pixel the visible part of each face covers. Montani and Re (1985),
// section 4, propose it: "the extra information given by the PCS (the sides of type 1 and 3 of a substripe) could be
// efficiently exploited by implementing an appropriate anti-aliasing technique".
//
// The parts are those of the stripes' trapezoids, each side's to 2^-20 of a pixel. Two faces at a side share its pixels exactly,
// so the parts of a pixel that is covered add up to all of it.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "host/algorithms/montani_re/priority.hpp"
#include "host/algorithms/montani_re/stripes.hpp"
#include "host/algorithms/montani_re/trapezoid_pcs.hpp"

namespace sightline::algorithms::montani_re {

// The whole of a pixel, of which parts are given.
[[nodiscard]] constexpr std::int64_t whole_pixel(std::int32_t units) {
  return std::int64_t{units} << 20;
}

// A part of the pixel in `column` and `row` (from the bottom) that `face` covers. A pixel may be told in several parts.
using TakePart = std::function<void(std::uint32_t face, std::int32_t column, std::int32_t row, std::int64_t part)>;

// The arguments are those of raster_by_difference. Returns the number of sides of the visible regions.
std::uint64_t coverage_by_difference(const Image& image, const PriorityList& list, std::span<const TrapezoidPcs> listed,
                                     const StripeFrame& frame, std::int32_t units, const TakePart& take);

}  // namespace sightline::algorithms::montani_re
