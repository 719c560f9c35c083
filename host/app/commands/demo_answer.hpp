// How fast and how wrong each method is on the scenes and functions of `sightline demo`: the rows of the table, the points of the
// plot.
//
// The built-in scenes of cells from their own views, the functions of the figures rotated 30 degrees, a scene of boxes from its
// own view, and one in parallel projection, so that every method of the five papers occurs.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "host/base/json.hpp"
#include "host/compare/answer.hpp"
#include "host/compare/answer_plot.hpp"
#include "host/compare/heights.hpp"
#include "host/compare/scenes.hpp"

namespace sightline::app {

struct DemoAnswer {
  std::vector<compare::SceneComparison> scenes;
  std::vector<std::pair<std::string, compare::HeightComparison>> functions;  // by name; lines
  std::vector<compare::AnswerRow> rows;                                      // a scene or function and method each
  std::vector<compare::AnswerRow> methods;  // a method each, over all of them; without what was read
  std::vector<compare::PlotPoint> plotted;
  std::string plotted_text;  // of what

  // No guest differs from its twin, no exact algorithm from the oracle.
  [[nodiscard]] bool agrees() const;
};

// Error program_failed: a scene cannot be compared.
[[nodiscard]] DemoAnswer answer_for_demo(bool host_times);

// Adds "table", "plot" and "compared".
void add_demo_answer(base::Json& document, const DemoAnswer& answer);

}  // namespace sightline::app
