// Tables 1 and 2 of Plantinga, Seales and Dyer (1990), beside the same figures of the six models here.
#pragma once

#include "host/report/report.hpp"

namespace sightline::harness::report {

[[nodiscard]] Outcome<std::vector<Block>> timing_of_plantinga(const Context& context);

}  // namespace sightline::harness::report
