// What Jones (1971) says of time and size, and the same of the program here.
#pragma once

#include "host/report/report.hpp"

namespace sightline::harness::report {

// Its tables and pictures, in order.
[[nodiscard]] Outcome<std::vector<Block>> timing_of_jones(const Context& context);

}  // namespace sightline::harness::report
