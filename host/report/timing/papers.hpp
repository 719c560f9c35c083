// Part 1 of the report: every number that the papers of the programs give for time or size, beside what the
// same programs take here, measured in this run.
#pragma once

#include "host/report/report.hpp"

namespace sightline::harness::report {

[[nodiscard]] Outcome<Section> timing_against_papers(const Context& context);

}  // namespace sightline::harness::report
