#include "host/compare/willis_8080.hpp"

#include <array>
#include <cstdint>

#include "host/algorithms/willis/frame.hpp"
#include "host/algorithms/willis/spans.hpp"
#include "host/compare/faces.hpp"
#include "host/programs/flight/flight.hpp"

namespace sightline::compare {

namespace {

namespace flight = programs::flight;
namespace willis = algorithms::willis;

base::Result<registry::FaceView> view_on_8080(const scene::PolyScene& scene, const willis::ModelOptions& options, const scene::PolyCamera& camera,
                                              const registry::FaceWindow& shown) {
  const auto model = flight::view_model(scene, options, camera);
  if (!model) return model.error();
  if (auto error = willis::plan_error(*model, camera)) return base::bad_input(*error);
  // Drawn twice, for the time: the first frame begins with sending the pieces to the machine.
  const std::array path{camera, camera};
  const auto run = flight::run({.model = *model, .path = path, .precision = flight::Precision::bits_16, .check = true});
  if (!run) base::give_up(run.error().message());
  willis::Frames frames(*model);
  const flight::ShownOrder order = flight::shown_order(*model, camera, frames.order(camera), run->flight.frames.at(0).priorities);
  const willis::ImageWindow window{shown.width, shown.height, shown.scale, shown.left, shown.top};
  willis::FrameSpans spans;
  willis::make_spans(*model, order.pieces, camera, window, spans);
  registry::FaceView view;
  view.faces = willis::resolve_priorities(spans, window);
  view.counts = {{"pieces", model->pieces.size()}, {"facing", order.pieces.size()}, {wrong_orders_name, order.wrong},
                 {t_states_name, static_cast<std::uint64_t>(run->frames.at(1).computing.count())}};
  return view;
}

base::Result<registry::PreparedFaces> prepare_8080(const scene::PolyScene& scene, const registry::FaceOptions& options) {
  willis::ModelOptions model_options;
  model_options.plan = options.plan;
  model_options.vertical = options.vertical;
  if (options.most_pairs) model_options.limits.tests = *options.most_pairs;
  registry::PreparedFaces prepared;
  prepared.view = [&scene, model_options](const scene::PolyCamera& camera, const registry::FaceWindow& window) {
    return view_on_8080(scene, model_options, camera, window);
  };
  return prepared;
}

constexpr registry::FaceAlgorithm on_8080{"willis-8080", "Willis's priorities, computed by an 8080 with coordinates of 16 bits", prepare_8080};

}  // namespace

const registry::FaceAlgorithm& willis_on_8080() { return on_8080; }

}  // namespace sightline::compare
