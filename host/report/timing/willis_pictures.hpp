// What a wrong order looks like: one view of a town whose surfaces are cut never, once, and as often as it takes.
#pragma once

#include "host/report/report.hpp"

namespace sightline::harness::report {

// Three pictures of the view in which most is wrong with nothing cut.
[[nodiscard]] Outcome<Gallery> willis_pictures();

}  // namespace sightline::harness::report
