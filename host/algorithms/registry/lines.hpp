// The algorithms that draw polyhedral scenes as lines, all behind one door: what draws, sweeps, compares and
// reports reads this table, so that an algorithm is one folder and one line here.
//
// Algorithms that give a face for every pixel instead of pieces of edges have a table of their own kind;
// Skala's, which wants a height grid, is not one of these.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/algorithms/registry/mesh_time.hpp"
#include "host/base/result.hpp"
#include "host/picture/edge_choice.hpp"
#include "host/picture/line_picture.hpp"
#include "host/scene/model/cell_complex.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::registry {

// What an algorithm did, in its own terms.
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
  // One view. The eye of a camera in perspective is in free space (scene::eye_error finds nothing: precondition). Several threads may
  // ask at once.
  std::function<base::Result<LineView>(const scene::PolyCamera&)> view;
  // The same of an ascending choice of edges alone; not all have it: see view_of.
  std::function<base::Result<LineView>(const scene::PolyCamera&, const picture::ChosenEdges&)> view_chosen = {};
  std::vector<AlgorithmCount> counts;  // of what was made of the scene
};

struct LineAlgorithm {
  std::string_view name;
  std::string_view description;  // and its source
  // Why the algorithm does not apply to the scene; empty if it does.
  std::optional<std::string> (*why_not)(const scene::PolyScene& scene);
  // What all views of a scene share. The scene is a checked one, to which the algorithm applies
  // (preconditions), and outlives what is prepared.
  base::Result<PreparedScene> (*prepare)(const scene::PolyScene& scene);
  // Of edges that lie on each other in the image it draws the nearest only: its picture is compared with
  // others as the set of points it draws (picture::image_set), not piece by piece.
  bool same_by_image = false;
  // Why it does not apply to a view of a scene to which it applies; null if it applies to all.
  std::optional<std::string> (*why_not_view)(const scene::PolyScene& scene,
                                             const scene::PolyCamera& camera) = nullptr;
  // `prepare` of a scene that already has cells; null if it does not use them. The complex is a
  // checked one (precondition).
  PreparedScene (*prepare_cells)(scene::CellComplex complex) = nullptr;
  bool draws_crossings = false;  // bodies may pass through each other: PolyScene::crossings and wires are drawn, too
  // `prepare` of views each of which uses so many threads, for the same picture; null if a view uses one.
  base::Result<PreparedScene> (*prepare_threads)(const scene::PolyScene& scene, unsigned jobs) = nullptr;
  MeshTime mesh_time = {};

  [[nodiscard]] std::optional<std::string> why_not_seen(const scene::PolyScene& scene,
                                                        const scene::PolyCamera& camera) const {
    return why_not_view == nullptr ? std::nullopt : why_not_view(scene, camera);
  }
};

// A view of edges chosen, also by an algorithm that can only draw all of them.
[[nodiscard]] base::Result<LineView> view_of(const PreparedScene& prepared, const scene::PolyCamera& camera,
                                             const picture::ChosenEdges& chosen);

// All, `exact` first: the others are compared with it.
[[nodiscard]] std::span<const LineAlgorithm> line_algorithms();
// Whether a picture of an algorithm is the right one, given that of `exact`.
[[nodiscard]] bool agrees(const LineAlgorithm& algorithm, const picture::LinePicture& drawn,
                          const picture::LinePicture& exact, const scene::PolyScene& scene,
                          const scene::PolyCamera& camera);
// Null if there is none of that name.
[[nodiscard]] const LineAlgorithm* find_line_algorithm(std::string_view name);

}  // namespace sightline::registry
