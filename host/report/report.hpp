// What chapters need that are not data files and experiments yet (legacy.hpp).
#pragma once

#include <vector>

#include "host/base/file.hpp"
#include "host/report/document.hpp"
#include "host/report/experiment.hpp"

namespace sightline::harness::report {

using namespace sightline::report;

}  // namespace sightline::harness::report
