// Records of the cross-check of all algorithms (host/compare/cross_check.hpp).
#pragma once

#include "host/compare/cross_check.hpp"
#include "host/report/records.hpp"

namespace sightline::report {

// Adds the records of one scene: to cells, failures, scenes and pictures.
void add_cross_check(Records& records, const compare::CommonScene& scene, const compare::SceneCrossCheck& agreement);

}  // namespace sightline::report
