// Part 1 of the report, Willis (1977): his areas and his frame rate beside ours, and what his 90-degree rule
// costs and saves.
#pragma once

#include "host/report/report.hpp"

namespace sightline::harness::report {

[[nodiscard]] Outcome<std::vector<Block>> timing_of_willis(const Context& context);

}  // namespace sightline::harness::report
