// The scenes on which Willis's method is measured, and their models, which both of its experiments use.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host/algorithms/willis/model.hpp"
#include "host/scene/generate/scene.hpp"

namespace sightline::report {

struct WillisScene {
  std::string name;
  scene::PolyScene scene;
  bool plan = false;  // distances and lengths in plan, as in the paper

  [[nodiscard]] std::string title() const { return name + (plan ? ", in plan" : ""); }
  [[nodiscard]] algorithms::willis::Model model(algorithms::willis::ModelOptions options = {}) const {
    options.plan = plan;
    // Generated scenes have no unsuitable faces (too many corners, no wall), so this cannot fail.
    return *algorithms::willis::make_model(scene, options);
  }
};

// A smaller town with wider gaps, because the boundaries of high walls are large in space.
[[nodiscard]] inline WillisScene prisms_in_space() {
  return {"prisms-12, gaps of 160", scene::generate_prisms(12, 3, 160), false};
}

// Two towns of 35 turned houses in plan; scenes in space.
[[nodiscard]] inline std::vector<WillisScene> willis_order_scenes() {
  return {{"prisms-35", scene::generate_prisms(35), true},
          {"prisms-35, seed 2", scene::generate_prisms(35, 2), true},
          prisms_in_space(),
          {"boxes-30", scene::generate_boxes(30), false}};
}

// A model of one of these scenes, ordered by distance alone, as in the paper: without order cells.
struct WillisModelKind {
  algorithms::willis::PairRules rules;
  int depth = 0;  // limit of cuts

  [[nodiscard]] algorithms::willis::ModelOptions options() const {
    algorithms::willis::ModelOptions made;
    made.rules = rules;
    made.order_cells = false;
    made.limits.depth = depth;
    return made;
  }
  [[nodiscard]] const char* boundary() const {
    return rules.shape == algorithms::willis::BoundaryShape::oval ? "oval" : "ball";
  }
};

// Both boundaries, the 90-degree rule off and on; 0 to 8 cuts, the fewest first.
inline constexpr int deepest_cuts = 8;
[[nodiscard]] inline std::vector<WillisModelKind> willis_model_kinds() {
  using algorithms::willis::BoundaryShape;
  std::vector<WillisModelKind> kinds;
  for (const BoundaryShape shape : {BoundaryShape::ball, BoundaryShape::oval})
    for (const bool rule90 : {false, true})
      for (int depth = 0; depth <= deepest_cuts; ++depth) kinds.push_back({{shape, rule90}, depth});
  return kinds;
}

}  // namespace sightline::report
