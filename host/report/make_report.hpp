// Runs experiments and writes the chapters that take their data.
#pragma once

#include <span>

#include "host/report/document.hpp"
#include "host/report/experiment.hpp"
#include "host/report/sections.hpp"

namespace sightline::report {

// The data that the parts of these numbers take, or all of them if there are none. Every experiment is run once; those
// that take times of this computer run alone, the others on all processors. An error of any ends it.
[[nodiscard]] base::Result<Results> run_experiments(std::span<const int> parts, const Context& context);

// The parts of these numbers, or the whole report, of data that are there.
[[nodiscard]] base::Result<Report> report_of(std::span<const int> parts, const Results& results, const Context& context);

// Both.
[[nodiscard]] base::Result<Report> make_report(std::span<const int> parts, const Context& context);

}  // namespace sightline::report
