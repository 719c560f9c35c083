// How the time of a view changes while the part of a building that is not seen grows: "cells to which access
// is not gained in this way are never even considered" (Jones 1971).
#pragma once

#include "host/report/report.hpp"

namespace sightline::harness::report {

[[nodiscard]] Outcome<std::vector<Block>> unseen_building(const Context& context);

}  // namespace sightline::harness::report
