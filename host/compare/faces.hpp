// Compares item buffers with the nearest face, found for every point independently
// (host/algorithms/oracle/face_raster.hpp). If coplanar faces share a point, each of them is right there.
//
// Left out: scenes of very many faces, for which that oracle takes too long, and parallel views of scenes that are
// thousands of times deeper than wide.
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

// The name of the count of T-states, the time of a program on the 8080.
inline constexpr std::string_view t_states_name = "t_states";
// The name of the count of pairs of pieces that rounding puts into another order than the exact one.
inline constexpr std::string_view wrong_orders_name = "wrong_orders";

struct ComparedFaces {
  std::string name;
  picture::PixelMetrics metrics;
  picture::PixelGrid truth;  // face number over all bodies + 1, 0 for none; of coplanar faces, the one drawn
  picture::PixelGrid grid;
  std::size_t not_solved = 0;  // pairs of faces that the algorithm reports as possibly wrong
  std::vector<registry::FaceCount> counts{};
  std::optional<double> emulated_seconds{};  // of a program: the time of the picture on its machine
  std::optional<double> host_seconds{};      // of other methods, if requested: the median of repeated runs

  // Whether nothing is wrong away from edges, or the algorithm reported that it may be.
  [[nodiscard]] bool agrees() const { return not_solved > 0 || metrics.different_inside == 0; }
};

// The reference of a view, with which algorithms are compared.
class FaceTruth {
 public:
  // The part of the scene before the eye on 256 by 256 points. An error says why there is no reference for the view.
  [[nodiscard]] static base::Result<FaceTruth> of(const scene::PolyScene& scene,
                                                  const scene::PolyCamera& camera);

  // An error says why the algorithm does not apply.
  [[nodiscard]] base::Result<ComparedFaces> compare(const registry::FaceAlgorithm& algorithm, bool host_times = false) const;

  // Compares a picture that was made elsewhere in the same window.
  [[nodiscard]] ComparedFaces compare(std::string name, picture::PixelGrid drawn, std::size_t not_solved) const;

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
