// See algorithms.hpp.
#include "host/harness/algorithms.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/oracle/edge_oracle.hpp"

namespace sightline::harness {

namespace {

std::optional<std::string> applies(const scene::PolyScene&) {
  return std::nullopt;
}

std::variant<PreparedScene, scene::SceneError> prepare_exact(const scene::PolyScene& scene) {
  const auto mesh = std::make_shared<const algorithms::exact::EdgeMesh>(algorithms::exact::make_edge_mesh(scene));
  PreparedScene prepared;
  prepared.counts = {{"edges", mesh->edges.size()}, {"faces", mesh->faces.size()}};
  prepared.view = [mesh](const scene::PolyCamera& camera) -> std::variant<LineView, scene::SceneError> {
    return LineView{algorithms::exact::visible_edges(*mesh, camera), {}};
  };
  return prepared;
}

std::variant<PreparedScene, scene::SceneError> prepare_oracle(const scene::PolyScene& scene) {
  PreparedScene prepared;
  prepared.view = [&scene](const scene::PolyCamera& camera) -> std::variant<LineView, scene::SceneError> {
    return LineView{algorithms::oracle::visible_edges(scene, camera), {}};
  };
  return prepared;
}

constexpr std::array table{
    LineAlgorithm{"exact", "Exact visible edges of any scene, fast: for a correct drawing today", applies,
                  prepare_exact},
    LineAlgorithm{"oracle", "Exact visible edges, slow and simple: what the others are checked by", applies,
                  prepare_oracle},
};

}  // namespace

std::span<const LineAlgorithm> line_algorithms() {
  return table;
}

const LineAlgorithm* find_line_algorithm(std::string_view name) {
  const auto found = std::find_if(table.begin(), table.end(),
                                  [name](const LineAlgorithm& algorithm) { return algorithm.name == name; });
  return found != table.end() ? &*found : nullptr;
}

}  // namespace sightline::harness
