// Measures the speed and the error of each method on the scenes and functions of `sightline demo`: the rows of the table and the
// points of the plot.
//
// The views: the built-in scenes of cells and a scene of boxes from their own cameras, the functions of the figures rotated 30
// degrees, and a scene of boxes in parallel projection. Every method of the five papers applies to one of them.
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
  std::vector<std::pair<std::string, compare::HeightComparison>> functions;  // name and comparison, drawn as lines
  std::vector<compare::AnswerRow> rows;                                      // one for each scene or function and method
  std::vector<compare::AnswerRow> methods;  // one for each method, over all scenes and functions; without `read`
  std::vector<compare::PlotPoint> plotted;
  std::string plotted_text;  // what the plot shows

  // Whether every guest agrees with its twin and every exact algorithm with the oracle.
  [[nodiscard]] bool agrees() const;
};

// Error program_failed: a scene cannot be compared.
[[nodiscard]] DemoAnswer answer_for_demo(bool host_times);

// Adds "table", "plot" and "compared".
void add_demo_answer(base::Json& document, const DemoAnswer& answer);

}  // namespace sightline::app
