// The last part of `sightline demo`: what both machines drew, compared with the oracles and beside the native
// algorithms.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "host/base/json.hpp"
#include "host/compare/heights.hpp"
#include "host/compare/scenes.hpp"

namespace sightline::app {

struct DemoComparison {
  std::vector<compare::SceneComparison> scenes;                              // the built-in ones
  std::vector<std::pair<std::string, compare::HeightComparison>> functions;  // by name; lines

  // No guest differs from its twin, no exact algorithm from the oracle.
  [[nodiscard]] bool agrees() const;
};

// Every scene from its own view, every function of the figures as `sightline demo` draws it. Failure
// guest_failed: a scene cannot be compared.
[[nodiscard]] DemoComparison compare_for_demo();

[[nodiscard]] std::string demo_comparison_table(const DemoComparison& comparison);
// Adds "compared".
void add_demo_comparison(base::Json& document, const DemoComparison& comparison);

}  // namespace sightline::app
