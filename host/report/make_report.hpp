// Runs experiments and writes the chapters that use their data.
#pragma once

#include <span>

#include "host/report/document.hpp"
#include "host/report/experiment.hpp"
#include "host/report/sections.hpp"

namespace sightline::report {

// Runs the experiments of these parts, or all if there are none, once each. Those that measure times of this computer
// run alone, the others on all processors. Returns the first error.
[[nodiscard]] base::Result<Results> run_experiments(std::span<const int> parts, const Context& context);

// The report of these parts, or the whole one, from the results.
[[nodiscard]] base::Result<Report> report_of(std::span<const int> parts, const Results& results, const Context& context);

// Runs the experiments and makes the report.
[[nodiscard]] base::Result<Report> make_report(std::span<const int> parts, const Context& context);

}  // namespace sightline::report
