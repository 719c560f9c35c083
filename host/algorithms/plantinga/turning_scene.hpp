// A scene of which several exact pictures are requested, along directions without a y component.
//
// The first picture is made from scratch, like the paper's initial picture. When the second one is requested, the events
// of a full turn are found; later pictures are made by stepping through them. Pictures exactly at an event, and all
// pictures of scenes with too many edges, are made from scratch.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "host/algorithms/plantinga/edge_structure_graph.hpp"
#include "host/algorithms/plantinga/visible_edges.hpp"
#include "host/base/threads.hpp"

namespace sightline::algorithms::plantinga {

// Scenes with more edges are rejected, because every face may hide part of every edge.
inline constexpr std::size_t most_edges = 60000;
// Scenes with more edges are always drawn from scratch.
inline constexpr std::size_t most_turned_edges = 3000;

// Why the algorithm does not apply to a scene or to a camera.
[[nodiscard]] std::optional<std::string> why_not(const scene::PolyScene& scene);
[[nodiscard]] std::optional<std::string> why_not_view(const scene::PolyScene& scene,
                                                      const scene::PolyCamera& camera);

class TurningScene {
 public:
  // Preconditions: the scene is checked and the algorithm applies to it.
  explicit TurningScene(const scene::PolyScene& scene) : model_(scene) {}

  [[nodiscard]] const RotationModel& model() const { return model_; }
  // May be called from any thread. Precondition: the parts of the sight are below 2^15.
  [[nodiscard]] picture::LinePicture view(const Sight& sight);

 private:
  // A picture found through the events; nullopt exactly at an event.
  std::optional<picture::LinePicture> turned_view(const Sight& sight);

  RotationModel model_;
  base::Mutex mutex_;
  bool asked_ = false;
  bool studied_ = false;
  EventList list_;
  std::unique_ptr<EdgeStructureGraph> graph_;
};

}  // namespace sightline::algorithms::plantinga
