// Compares item buffers (the visible face at each point) with the nearest face found for every point by
// itself (host/algorithms/oracle/face_raster.hpp). Where faces lie in one plane and share the point, none of them is before the
// other: each of them is right there.
//
// Left out: scenes of very many faces, for which that oracle has no answer in time, and parallel views along
// scenes that are thousands of times deeper than they are wide.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/algorithms/registry/faces.hpp"
#include "host/base/result.hpp"
#include "host/picture/pixel_metrics.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::compare {

// The count of a program on the 8080 that is its time.
inline constexpr std::string_view t_states_name = "t_states";
// The count of pairs of pieces that rounding has put into another order than the exact one.
inline constexpr std::string_view wrong_orders_name = "wrong_orders";

struct ComparedFaces {
  std::string name;
  picture::PixelMetrics metrics;
  picture::PixelGrid truth;  // numbers of faces over all bodies + 1, 0 where there is none; of several in one plane, the one drawn
  picture::PixelGrid grid;
  std::size_t not_solved = 0;  // pairs of faces the algorithm itself says it may draw wrongly
  std::vector<registry::FaceCount> counts{};
  std::optional<double> emulated_seconds{};  // of a program on its machine: what the picture took there
  std::optional<double> host_seconds{};      // else, if asked for: the median of repeated views here

  // Nothing is wrong away from edges, or the algorithm said so itself.
  [[nodiscard]] bool agrees() const { return not_solved > 0 || metrics.different_inside == 0; }
};

// What all algorithms of a view are compared with.
class FaceTruth {
 public:
  // All of the scene before the eye on 256 by 256 points. An error says why there is no truth of the view.
  [[nodiscard]] static base::Result<FaceTruth> of(const scene::PolyScene& scene,
                                                  const scene::PolyCamera& camera);

  // An error says why the algorithm does not apply.
  [[nodiscard]] base::Result<ComparedFaces> compared(const registry::FaceAlgorithm& algorithm, bool host_times = false) const;

  // The same of a picture that something else has made in the window.
  [[nodiscard]] ComparedFaces compared(std::string name, picture::PixelGrid drawn, std::size_t not_solved) const;

  [[nodiscard]] const picture::PixelGrid& faces() const { return faces_; }
  [[nodiscard]] const registry::FaceWindow& window() const { return window_; }

 private:
  FaceTruth(const scene::PolyScene& scene, const scene::PolyCamera& camera,
            const registry::FaceWindow& window);

  const scene::PolyScene* scene_;
  scene::PolyCamera camera_;
  registry::FaceWindow window_;
  struct Sights;
  std::shared_ptr<const Sights> sights_;
  picture::PixelGrid faces_;
  std::vector<picture::PixelSegment> edges_;
};

}  // namespace sightline::compare
