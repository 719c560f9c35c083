// Native Jones in buildings of more and more rooms: nothing a view does may depend on how many there are.
#pragma once

#include "host/report/report.hpp"

namespace sightline::harness::report {

// A table of counts, and with times of this computer also a plot of them.
[[nodiscard]] Outcome<std::vector<Block>> unseen_native(const Context& context);

}  // namespace sightline::harness::report
