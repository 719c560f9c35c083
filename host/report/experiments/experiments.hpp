// What experiments.cpp lists, an experiment a line; the file of an experiment says what its records are.
#pragma once

#include "host/report/experiment.hpp"

namespace sightline::report {

[[nodiscard]] Records hard_cases(const Context& context);

}  // namespace sightline::report
