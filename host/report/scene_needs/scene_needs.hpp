// Part 4 of the report: what each scene and function needed of its machine, against what there was, and how
// the time of a view changes while the part of a building that is not seen grows.
#pragma once

#include "host/report/report.hpp"

namespace sightline::harness::report {

[[nodiscard]] Outcome<Section> scene_needs(const Context& context);

}  // namespace sightline::harness::report
