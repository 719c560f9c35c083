// What Montani and Re (1985) say of size and work, and the same of the program here: Tables 1, 3 and 4, and
// the growth of a view.
#pragma once

#include "host/harness/report/report.hpp"

namespace sightline::harness::report {

// Its tables, in order.
[[nodiscard]] Outcome<std::vector<Block>> timing_of_montani_re(const Context& context);

}  // namespace sightline::harness::report
