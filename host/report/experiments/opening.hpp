// The opening of the report: the speed and accuracy of every method, on one view of each scene and function, and the
// references used.
//
// A sentence for each of the three, the plot of time against error, a table of methods, and the whole table, one row
// per method and scene. The measures are those of `compare` (host/compare/answer.hpp).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host/compare/answer.hpp"
#include "host/compare/answer_plot.hpp"
#include "host/report/experiment.hpp"
#include "host/report/page.hpp"

namespace sightline::report {

struct OpeningAnswer {
  std::vector<compare::AnswerRow> rows;     // by scene
  std::vector<compare::AnswerRow> methods;  // each over all its scenes
  std::vector<compare::PlotPoint> plotted;  // of one scene of cells, one of polyhedra and a function
  std::string of_plot;                      // the names of these, in words
  std::size_t scenes = 0;
  std::size_t functions = 0;
};

[[nodiscard]] OpeningAnswer opening_answer(const Context& context);

void opening(Page& page, const OpeningAnswer& answer);

}  // namespace sightline::report
