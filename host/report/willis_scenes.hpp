// The scenes on which Willis's method is measured in the report.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host/algorithms/willis/model.hpp"
#include "host/report/willis_views.hpp"
#include "host/scene/generate/scene.hpp"

namespace sightline::harness::report {

struct WillisScene {
  std::string name;
  scene::PolyScene scene;
  bool plan = false;  // distances and lengths in plan, as the paper has them

  [[nodiscard]] std::string title() const { return name + (plan ? ", in plan" : ""); }
  [[nodiscard]] algorithms::willis::Model model(algorithms::willis::ModelOptions options = {}) const {
    options.plan = plan;
    // Generated scenes have no face that cannot be taken (too many corners, no wall).
    return *algorithms::willis::make_model(scene, options);
  }
};

// In space the boundaries of high walls reach far: a smaller town with wider gaps.
inline constexpr std::size_t few_prisms = 12;
inline constexpr std::int32_t wide_gap = 160;
[[nodiscard]] inline WillisScene prisms_in_space() {
  return {"prisms-12, gaps of 160", scene::generate_prisms(few_prisms, 3, wide_gap), false};
}

// The town on which splitting was first measured, 35 turned houses, in plan, and another one; scenes in
// space.
[[nodiscard]] inline std::vector<WillisScene> willis_order_scenes() {
  return {{"prisms-35", scene::generate_prisms(35), true},
          {"prisms-35, seed 2", scene::generate_prisms(35, 2), true},
          prisms_in_space(),
          {"boxes-30", scene::generate_boxes(30), false}};
}

// From among the solids, where the order is hardest. In plan the eye is between feet and tops, as it is here.
[[nodiscard]] inline TrueFaces true_faces(const scene::PolyScene& scene) {
  constexpr std::size_t eyes = 160;
  constexpr int size = 24;
  return {scene, cameras_within(scene, eyes), size};
}

// Lines to be counted: in space there are few that meet two surfaces, and finding them takes longer.
[[nodiscard]] inline std::uint64_t sight_lines(const WillisScene& scene, std::uint64_t in_plan) {
  return scene.plan ? in_plan : in_plan / 4;
}

}  // namespace sightline::harness::report
