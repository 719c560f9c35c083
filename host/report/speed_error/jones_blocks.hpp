// Tables and plots of what jones.hpp measures.
#pragma once

#include <vector>

#include "host/report/report.hpp"
#include "host/report/speed_error/jones.hpp"

namespace sightline::harness::report {

// Of the machine, and of words and numbers of other kinds.
[[nodiscard]] Table machine_error_table(const std::vector<JonesMeasured>& scenes);
[[nodiscard]] Table twin_error_table(const std::vector<JonesMeasured>& scenes);

// Tables first, then plots; those of times of this computer only if they were taken.
[[nodiscard]] Outcome<std::vector<Block>> jones_error_blocks(const std::vector<JonesMeasured>& scenes);

}  // namespace sightline::harness::report
