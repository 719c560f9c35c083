// Part 2 of the report: speed against error. How wrong the pictures of each program are in arithmetic, raster
// and grid of every size, beside the time they take: seconds of the emulated machines, and nanoseconds of
// this computer, in figures of their own.
//
// Source of the measures of error and of what is varied: the suite's cross-check of algorithms, sections 4
// and 5.
#pragma once

#include "host/report/report.hpp"

namespace sightline::harness::report {

[[nodiscard]] Outcome<Section> speed_against_error(const Context& context);

}  // namespace sightline::harness::report
