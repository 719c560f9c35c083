// Runs experiments and makes of their records what the data files say.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "host/report/document.hpp"
#include "host/report/experiment.hpp"
#include "host/report/render.hpp"

namespace sightline::report {

// What people can ask for, ascending. Error bad_input: a data file that cannot be used.
[[nodiscard]] Outcome<std::vector<PartLayout>> all_parts();

// The parts of these numbers, or all of them if there are none; every experiment that they take records of is run once.
// Those that take times of this computer run alone, the others on all processors. An error of any ends it.
[[nodiscard]] Outcome<Report> make_report(std::span<const int> parts, const Context& context);

// The same of records that are there: at least those that the parts take.
[[nodiscard]] Outcome<Report> report_of(std::span<const int> parts, const Results& results, const Context& context);

// The records of the experiments named, or of all.
[[nodiscard]] Outcome<Results> run_experiments(std::vector<std::string> names, const Context& context);

}  // namespace sightline::report
