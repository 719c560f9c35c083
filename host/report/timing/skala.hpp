// What Skala (1985) says of time and size, and the same of the program here.
#pragma once

#include "host/report/report.hpp"

namespace sightline::harness::report {

// Its tables and pictures, in order.
[[nodiscard]] Outcome<std::vector<Block>> timing_of_skala(const Context& context);

}  // namespace sightline::harness::report
