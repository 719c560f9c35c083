// The pictures that all methods make of one view of a common scene, side by side.
#pragma once

#include "host/compare/cross_check.hpp"
#include "host/report/report.hpp"

namespace sightline::harness::report {

// Of the first view; lines as lines, faces as areas. The caption names them from the left.
[[nodiscard]] Outcome<Figure> agreement_strip(const compare::CommonScene& scene,
                                              const compare::SceneCrossCheck& agreement);

}  // namespace sightline::harness::report
