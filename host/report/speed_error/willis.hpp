// Willis (1977): models cut to every depth, by both boundaries, with and without the 90-degree rule: how wrong
// the order of their surfaces is, and what they cost.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "host/algorithms/willis/boundary.hpp"
#include "host/algorithms/willis/sight_lines.hpp"
#include "host/report/report.hpp"
#include "host/report/willis_views.hpp"

namespace sightline::harness::report {

struct WillisPoint {
  int depth = 0;  // limit of cuts
  std::size_t pieces = 0;
  std::size_t left_over = 0;  // pairs
  FaceErrors faces;
  algorithms::willis::SightLines lines;
  std::optional<double> prepare_ns;  // the model
  std::optional<double> frame_ns;    // distances and sort
};

struct WillisCurve {
  std::string scene;
  algorithms::willis::PairRules rules;
  std::vector<WillisPoint> points;  // ascending by depth

  [[nodiscard]] std::string name() const;  // "prisms-35, in plan: oval, 90-degree rule"
};

// Without order cells: distance alone, as in the paper.
[[nodiscard]] std::vector<WillisCurve> measure_willis(const Context& context);

// Three plots and a table.
[[nodiscard]] Outcome<std::vector<Block>> willis_error_blocks(const std::vector<WillisCurve>& curves);

}  // namespace sightline::harness::report
