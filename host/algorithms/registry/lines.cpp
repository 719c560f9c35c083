#include "host/algorithms/registry/lines.hpp"

#include <algorithm>
#include <memory>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/registry/exact_lines.hpp"
#include "host/picture/line_picture_image.hpp"

namespace sightline::registry {

base::Result<PreparedScene> prepare_exact_threads(const scene::PolyScene& scene, unsigned jobs, bool of_chosen) {
  const auto mesh = std::make_shared<const algorithms::exact::EdgeMesh>(algorithms::exact::make_edge_mesh(scene, !of_chosen));
  PreparedScene prepared;
  if (!of_chosen) prepared.counts = {{"edges", mesh->edges.size()}, {"faces", mesh->faces.size()}};
  const auto watched = [mesh, jobs](const scene::PolyCamera& camera, const picture::ChosenEdges* chosen, const base::Watch& watch,
                                    std::vector<algorithms::exact::EdgeProof>* proofs) -> base::Result<LineView> {
    if (proofs != nullptr) return LineView{algorithms::exact::visible_edges(*mesh, camera, chosen, *proofs, watch), {}};
    return LineView{algorithms::exact::visible_edges(*mesh, camera, chosen, jobs, watch), {}};
  };
  prepared.view_watched = watched;
  prepared.view = [watched](const scene::PolyCamera& camera) { return watched(camera, nullptr, {}, nullptr); };
  prepared.view_chosen = [watched](const scene::PolyCamera& camera, const picture::ChosenEdges& chosen) { return watched(camera, &chosen, {}, nullptr); };
  return prepared;
}

base::Result<PreparedScene> prepare_exact(const scene::PolyScene& scene) {
  return prepare_exact_threads(scene, 1, false);
}

base::Result<LineView> view_of(const PreparedScene& prepared, const scene::PolyCamera& camera,
                               const picture::ChosenEdges& chosen) {
  if (prepared.view_chosen) return prepared.view_chosen(camera, chosen);
  auto view = prepared.view(camera);
  if (view) view->picture = picture::only(view->picture, chosen);
  return view;
}

bool agrees(const LineAlgorithm& algorithm, const picture::LinePicture& drawn,
            const picture::LinePicture& exact, const scene::PolyScene& scene,
            const scene::PolyCamera& camera) {
  return drawn == exact ||
         (algorithm.same_by_image && image_set(drawn, scene, camera) == image_set(exact, scene, camera));
}

const LineAlgorithm* find_line_algorithm(std::string_view name) {
  const auto table = line_algorithms();
  const auto found = std::find_if(table.begin(), table.end(),
                                  [name](const LineAlgorithm& algorithm) { return algorithm.name == name; });
  return found != table.end() ? &*found : nullptr;
}

}  // namespace sightline::registry
