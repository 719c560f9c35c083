// Tables and plots of what skala.hpp measures.
#pragma once

#include <vector>

#include "host/report/report.hpp"
#include "host/report/speed_error/skala.hpp"

namespace sightline::harness::report {

// Plots, then tables; plots of times of this computer only if they were taken.
[[nodiscard]] Outcome<std::vector<Block>> skala_error_blocks(const SkalaMeasured& measured);

}  // namespace sightline::harness::report
