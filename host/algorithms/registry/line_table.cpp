// The table of all algorithms for lines. Programs that draw with `exact` alone have only_exact.cpp in its place.
#include <array>
#include <utility>

#include "host/algorithms/jones/visible_edges.hpp"
#include "host/algorithms/montani_re/visible_edges.hpp"
#include "host/algorithms/oracle/edge_oracle.hpp"
#include "host/algorithms/plantinga/turning_scene.hpp"
#include "host/algorithms/registry/exact_lines.hpp"
#include "host/algorithms/registry/lines.hpp"
#include "host/base/result.hpp"
#include "host/base/threads.hpp"
#include "host/scene/cells/decompose.hpp"

namespace sightline::registry {

namespace {

std::optional<std::string> applies(const scene::PolyScene&) {
  return std::nullopt;
}

base::Result<PreparedScene> prepare_oracle(const scene::PolyScene& scene) {
  PreparedScene prepared;
  prepared.view = [&scene](const scene::PolyCamera& camera) -> base::Result<LineView> {
    return LineView{algorithms::oracle::visible_edges(scene, camera), {}};
  };
  prepared.view_chosen = [&scene](const scene::PolyCamera& camera,
                                  const picture::ChosenEdges& chosen) -> base::Result<LineView> {
    return LineView{algorithms::oracle::visible_edges(scene, camera, chosen), {}};
  };
  return prepared;
}

namespace native_jones = algorithms::jones;

// A walker serves one view at a time. Idle walkers are kept here.
class JonesScene {
 public:
  explicit JonesScene(scene::CellComplex complex) : complex_(std::move(complex)), prepared_(complex_) {}

  [[nodiscard]] const scene::CellComplex& complex() const { return complex_; }

  base::Result<LineView> view(const scene::PolyCamera& camera) {
    native_jones::Walker walker = take();
    auto result = walker.visible_edges(camera);
    give_back(std::move(walker));
    if (!result) return base::Error{"", "jones", result.error().message()};
    auto& seen = *result;
    const native_jones::Counts& c = seen.counts;
    return LineView{std::move(seen.picture),
                    {{"visits", c.visits},
                     {"cells", c.cells},
                     {"openings_tested", c.openings_tested},
                     {"masks", c.masks},
                     {"lines_clipped", c.lines_clipped},
                     {"fragments", c.fragments},
                     {"depth", c.depth},
                     {"mask_sides", c.mask_sides}}};
  }

 private:
  native_jones::Walker take() {
    const base::Lock lock(mutex_);
    if (idle_.empty()) return native_jones::Walker(prepared_);
    native_jones::Walker walker = std::move(idle_.back());
    idle_.pop_back();
    return walker;
  }
  void give_back(native_jones::Walker walker) {
    const base::Lock lock(mutex_);
    idle_.push_back(std::move(walker));
  }

  scene::CellComplex complex_;
  native_jones::PreparedComplex prepared_;
  base::Mutex mutex_;
  std::vector<native_jones::Walker> idle_;
};

PreparedScene prepare_jones_cells(scene::CellComplex complex) {
  const auto cells = std::make_shared<JonesScene>(std::move(complex));
  PreparedScene prepared;
  prepared.counts = {{"cells", cells->complex().cells.size()},
                     {"openings", cells->complex().openings.size()}};
  prepared.view = [cells](const scene::PolyCamera& camera) { return cells->view(camera); };
  return prepared;
}

base::Result<PreparedScene> prepare_jones(const scene::PolyScene& scene) {
  auto complex = scene::decompose(scene);
  if (!complex) return std::move(complex.error());
  return prepare_jones_cells(std::move(*complex));
}

base::Result<PreparedScene> prepare_montani_re(const scene::PolyScene& scene) {
  PreparedScene prepared;
  prepared.view = [&scene](const scene::PolyCamera& camera) -> base::Result<LineView> {
    auto result = algorithms::montani_re::visible_edges(scene, camera);
    if (!result) return std::move(result.error());
    auto& seen = *result;
    const algorithms::montani_re::RegionCounts& c = seen.counts;
    return LineView{std::move(seen.picture),
                    {{"relations", c.relations},
                     {"spurious_relations", c.spurious},
                     {"cycles_cut", c.cuts},
                     {"mutual_parts", c.mutual_parts},
                     {"subtractions", c.subtractions},
                     {"sides", c.sides}}};
  };
  return prepared;
}

base::Result<PreparedScene> prepare_plantinga(const scene::PolyScene& scene) {
  const auto turning = std::make_shared<algorithms::plantinga::TurningScene>(scene);
  PreparedScene prepared;
  prepared.counts = {{"edges", turning->model().edges().size()}, {"faces", turning->model().faces().size()}};
  prepared.view = [turning](const scene::PolyCamera& camera) -> base::Result<LineView> {
    const auto sight = algorithms::plantinga::sight_of(camera);
    if (!sight) return base::Error{"", "camera", "the line of sight is not parallel to y = 0"};
    return LineView{turning->view(*sight), {}};
  };
  return prepared;
}

constexpr std::array table{
    exact_lines,
    LineAlgorithm{"jones", "From cell to cell through openings, after Jones (1971), in general position",
                  applies, prepare_jones, false, nullptr, prepare_jones_cells, false, nullptr, {17, true}},
    LineAlgorithm{"montani-re", "Priority list of faces in stripes, after Montani and Re (1985), exact",
                  applies, prepare_montani_re, true},
    LineAlgorithm{"oracle", "Exact visible edges, slow and simple: the reference for all others", applies,
                  prepare_oracle, false, nullptr, nullptr, true, nullptr, {6, false}},
    LineAlgorithm{"plantinga",
                  "One moment of a turn about the vertical, after Plantinga, Seales and Dyer (1990), exact",
                  algorithms::plantinga::why_not, prepare_plantinga, false,
                  algorithms::plantinga::why_not_view},
};

}  // namespace

std::span<const LineAlgorithm> line_algorithms() {
  return table;
}

}  // namespace sightline::registry
