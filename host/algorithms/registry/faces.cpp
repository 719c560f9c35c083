#include "host/algorithms/registry/faces.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "host/algorithms/registry/montani_re_faces.hpp"
#include "host/algorithms/registry/willis_display.hpp"
#include "host/algorithms/willis/frame.hpp"
#include "host/algorithms/willis/model.hpp"
#include "host/algorithms/willis/spans.hpp"
#include "host/base/result.hpp"

namespace sightline::registry {

namespace {

namespace willis = algorithms::willis;

willis::ImageWindow willis_window(const FaceWindow& window) {
  return {window.width, window.height, window.scale, window.left, window.top};
}

FaceWindow face_window_of(const willis::ImageWindow& window) {
  return {window.width, window.height, window.scale, window.left, window.top};
}

class WillisScene {
 public:
  explicit WillisScene(willis::Model model) : model_(std::move(model)), frames_(model_) {}

  [[nodiscard]] const willis::Model& model() const { return model_; }

  base::Result<FaceView> view(const scene::PolyCamera& camera, const FaceWindow& shown) {
    if (auto error = willis::plan_error(model_, camera)) return base::Error{"", "camera", std::move(*error)};
    const willis::ImageWindow window = willis_window(shown);
    const auto order = frames_.order(camera);
    willis::make_spans(model_, order, camera, window, spans_);
    FaceView view;
    // If the picture has the display's size, the display makes it.
    view.faces =
        fits_display(spans_, window) ? show_on_display(spans_, display_) : willis::resolve_priorities(spans_, window);
    view.counts = {
        {"distances", order.size()}, {"surfaces", spans_.surfaces.size()}, {"spans", spans_.spans.size()}};
    return view;
  }

 private:
  willis::Model model_;
  willis::Frames frames_;
  willis::FrameSpans spans_;
  WillisDisplay display_;
};

base::Result<PreparedFaces> prepare_willis(const scene::PolyScene& scene, const FaceOptions& options) {
  willis::ModelOptions model_options;
  if (options.depth) model_options.limits.depth = *options.depth;
  model_options.plan = options.plan;
  model_options.vertical = options.vertical;
  model_options.rules.rule90 = options.rule90;
  if (options.oval) model_options.rules.shape = willis::BoundaryShape::oval;
  model_options.order_cells = options.order_cells;
  if (options.most_pairs) model_options.limits.tests = *options.most_pairs;
  auto model = willis::make_model(scene, model_options);
  if (!model) return std::move(model.error());
  const auto made = std::make_shared<WillisScene>(std::move(*model));
  PreparedFaces prepared;
  prepared.counts = {{"surfaces", made->model().surfaces},
                     {"clusters", made->model().clusters},
                     {"pieces", made->model().pieces.size()},
                     {"order_cells", made->model().cells.cells},
                     {"residual", made->model().residual.size()}};
  prepared.not_solved = willis::residual_lines(made->model(), scene);
  prepared.view = [made](const scene::PolyCamera& camera, const FaceWindow& window) {
    return made->view(camera, window);
  };
  return prepared;
}

constexpr std::array face_rows{
    FaceAlgorithm{"montani-re", "Priority list of faces in stripes, after Montani and Re (1985); filled",
                  prepare_montani_re_faces},
    FaceAlgorithm{"willis",
                  "Surfaces by distance as their priority, after Willis (1977); filled, or a flight",
                  prepare_willis, {11, true}},
};

}  // namespace

std::span<const FaceAlgorithm> face_algorithms() {
  return face_rows;
}

const FaceAlgorithm* find_face_algorithm(std::string_view name) {
  const auto found = std::find_if(face_rows.begin(), face_rows.end(),
                                  [name](const FaceAlgorithm& algorithm) { return algorithm.name == name; });
  return found != face_rows.end() ? &*found : nullptr;
}

FaceWindow face_window(const scene::PolyScene& scene, const scene::PolyCamera& camera, int width, int height,
                       std::optional<double> extent) {
  return face_window_of(extent ? willis::window_ahead(camera, width, height, *extent)
                               : willis::window_around(scene, camera, width, height));
}

}  // namespace sightline::registry
