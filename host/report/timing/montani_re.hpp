// What Montani and Re (1985) say of size and work, and the same of the program here: Tables 1, 3 and 4, and
// the growth of a view.
#pragma once

#include <vector>

#include "host/report/montani_re_growth.hpp"
#include "host/report/report.hpp"

namespace sightline::harness::report {

// Its tables, in order.
[[nodiscard]] Outcome<std::vector<Block>> timing_of_montani_re(const Context& context);

// What the paper says of work and size in words, the growth measured, its exponents.
[[nodiscard]] Table montani_re_paper_table(const std::vector<MontaniReGrowth>& families);
[[nodiscard]] Table montani_re_growth_table(const std::vector<MontaniReGrowth>& families);
[[nodiscard]] Table montani_re_exponents_table(const std::vector<MontaniReGrowth>& families);

}  // namespace sightline::harness::report
