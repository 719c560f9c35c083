// The table of the algorithms that draw polyhedral scenes as lines. The commands and experiments read this table, so
// adding an algorithm takes one folder and one row here.
//
// Algorithms that find a face for every pixel are in faces.hpp, those that draw height grids in heights.hpp.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/algorithms/exact/witnesses.hpp"
#include "host/algorithms/registry/mesh_time.hpp"
#include "host/base/result.hpp"
#include "host/base/watch.hpp"
#include "host/picture/edge_choice.hpp"
#include "host/picture/line_picture.hpp"
#include "host/scene/model/cell_complex.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::registry {

// A count that an algorithm reports about its work, under the algorithm's own name for it.
struct AlgorithmCount {
  std::string_view name;
  std::uint64_t value = 0;

  friend bool operator==(const AlgorithmCount&, const AlgorithmCount&) = default;
};

struct LineView {
  picture::LinePicture picture;
  std::vector<AlgorithmCount> counts;
};

struct PreparedScene {
  // Computes one view. Precondition: the eye of a perspective camera is in free space (scene::eye_error returns nothing).
  // Thread-safe.
  std::function<base::Result<LineView>(const scene::PolyCamera&)> view;
  // The same for an ascending choice of edges only; null if the algorithm cannot restrict itself: see view_of.
  std::function<base::Result<LineView>(const scene::PolyCamera&, const picture::ChosenEdges&)> view_chosen = {};
  // The same for chosen edges, or all if there is no choice; followed by the watch; with a proof for each edge, if `proofs` is
  // given. Null if the algorithm has none.
  std::function<base::Result<LineView>(const scene::PolyCamera&, const picture::ChosenEdges*, const base::Watch&,
                                       std::vector<algorithms::exact::EdgeProof>* proofs)>
      view_watched = {};
  std::vector<AlgorithmCount> counts;  // about the preparation of the scene
};

struct LineAlgorithm {
  std::string_view name;
  std::string_view description;  // includes the source
  // Why the algorithm does not apply to the scene; nullopt if it does.
  std::optional<std::string> (*why_not)(const scene::PolyScene& scene);
  // Computes the data that all views of a scene share. Preconditions: the scene is checked, the algorithm applies to it,
  // and the scene outlives the result.
  base::Result<PreparedScene> (*prepare)(const scene::PolyScene& scene);
  // Of edges that coincide in the image, it draws only the nearest: its picture is compared with others as the set of
  // points it draws (picture::image_set), not piece by piece.
  bool same_by_image = false;
  // Why the algorithm does not apply to a view of a scene to which it applies; null if it applies to every view.
  std::optional<std::string> (*why_not_view)(const scene::PolyScene& scene,
                                             const scene::PolyCamera& camera) = nullptr;
  // Like `prepare`, for a scene that already has cells; null if the algorithm does not use cells. Precondition: the
  // complex is checked.
  PreparedScene (*prepare_cells)(scene::CellComplex complex) = nullptr;
  bool draws_crossings = false;  // bodies may pass through each other: it also draws PolyScene::crossings and wires
  // Like `prepare`, but each view uses up to `jobs` threads for the same picture; if `of_chosen`, there will be views of chosen edges
  // alone, and counts are left out. Null if a view uses only one thread.
  base::Result<PreparedScene> (*prepare_threads)(const scene::PolyScene& scene, unsigned jobs, bool of_chosen) = nullptr;
  MeshTime mesh_time = {};

  [[nodiscard]] std::optional<std::string> why_not_seen(const scene::PolyScene& scene,
                                                        const scene::PolyCamera& camera) const {
    return why_not_view == nullptr ? std::nullopt : why_not_view(scene, camera);
  }
};

// A view of chosen edges, also for algorithms that can only draw all edges.
[[nodiscard]] base::Result<LineView> view_of(const PreparedScene& prepared, const scene::PolyCamera& camera,
                                             const picture::ChosenEdges& chosen);

// All algorithms. `exact` is first: the others are compared with it.
[[nodiscard]] std::span<const LineAlgorithm> line_algorithms();
// Whether an algorithm's picture agrees with that of `exact`.
[[nodiscard]] bool agrees(const LineAlgorithm& algorithm, const picture::LinePicture& drawn,
                          const picture::LinePicture& exact, const scene::PolyScene& scene,
                          const scene::PolyCamera& camera);
// Null if no algorithm has this name.
[[nodiscard]] const LineAlgorithm* find_line_algorithm(std::string_view name);

}  // namespace sightline::registry
