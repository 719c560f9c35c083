// A scene of which exact pictures are asked for, one after the other, along directions without y.
//
// The first one is made from scratch, as the paper's initial picture is. When a second one is asked for the
// events of a full turn are found, and from then on pictures are made by stepping through them; those exactly
// at an event, and all of scenes with too many edges for that, from scratch.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "host/algorithms/plantinga/edge_structure_graph.hpp"
#include "host/algorithms/plantinga/visible_edges.hpp"
#include "host/base/threads.hpp"

namespace sightline::algorithms::plantinga {

// Scenes with more edges have no pictures: every face may hide some of every edge.
inline constexpr std::size_t most_edges = 60000;
// Scenes with more edges are drawn from scratch always.
inline constexpr std::size_t most_turned_edges = 3000;

// Why the algorithm does not apply: to a scene, to a camera.
[[nodiscard]] std::optional<std::string> why_not(const scene::PolyScene& scene);
[[nodiscard]] std::optional<std::string> why_not_view(const scene::PolyScene& scene,
                                                      const scene::PolyCamera& camera);

class TurningScene {
 public:
  // The scene is a checked one to which the algorithm applies (preconditions).
  explicit TurningScene(const scene::PolyScene& scene) : model_(scene) {}

  [[nodiscard]] const RotationModel& model() const { return model_; }
  // From any thread. The sight's parts keep below 2^15.
  [[nodiscard]] picture::LinePicture view(const Sight& sight);

 private:
  // Through the events; nothing at an event.
  std::optional<picture::LinePicture> turned_view(const Sight& sight);

  RotationModel model_;
  base::Mutex mutex_;
  bool asked_ = false;
  bool studied_ = false;
  EventList list_;
  std::unique_ptr<EdgeStructureGraph> graph_;
};

}  // namespace sightline::algorithms::plantinga
