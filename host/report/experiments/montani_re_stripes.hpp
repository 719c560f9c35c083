// Montani and Re's algorithm in stripes of every thickness, and exact: how wrong its pictures are, how long a
// view takes, how many sides there are.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host/algorithms/montani_re/stripes.hpp"
#include "host/picture/line_metrics.hpp"
#include "host/report/experiment.hpp"

namespace sightline::report {

// Thicknesses are 16 / units pixels.
inline constexpr std::array<std::int32_t, 6> stripe_units{2, 4, 8, 16, 32, 64};

struct MontaniReStripes {
  std::vector<std::string> scenes{"boxes", "town", "triangles"};  // generated
  std::size_t scene_size = 30;
  std::int32_t raster = 384;
  int rounds = 3;  // of times; 0: none
};
[[nodiscard]] Records measure_stripes(const MontaniReStripes& order, const Context& context);

// The boundary of stripes of so many sixteenths of a pixel, middles of pixels at whole numbers: sides, and
// horizontal pieces where what is above is covered and what is below not, or the other way round.
[[nodiscard]] std::vector<picture::PixelSegment> boundary_of(const algorithms::montani_re::StripePcs& pcs,
                                                             std::int32_t units);

}  // namespace sightline::report
