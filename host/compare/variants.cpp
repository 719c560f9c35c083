// See variants.hpp.
#include "host/compare/variants.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <numbers>
#include <string_view>
#include <utility>

#include "host/algorithms/plantinga/edge_structure_graph.hpp"
#include "host/algorithms/plantinga/frame.hpp"
#include "host/algorithms/registry/faces.hpp"
#include "host/compare/answer.hpp"
#include "host/compare/host_time.hpp"
#include "host/compare/turn_error.hpp"
#include "host/scene/model/aim_camera.hpp"
#include "host/scene/model/poly_from_cells.hpp"

namespace sightline::compare {
namespace {

namespace plantinga = algorithms::plantinga;

constexpr std::string_view montani_re = "montani-re";

// Adds a point for each time that the view has.
void add_point(const MethodView& view, const std::string& series, const std::string& label, std::vector<PlotPoint>& points) {
  const double shown_percent = view.exact && *view.exact ? 0 : wrong_percent(view);
  if (view.emulated_seconds) points.push_back({PlotPanel::emulated, series, label, *view.emulated_seconds, shown_percent});
  if (view.host_seconds) points.push_back({PlotPanel::host, series, label, *view.host_seconds, shown_percent});
}

// Methods without a setting. Those with one are added by the functions below.
void add_plain(const SceneComparison& comparison, std::vector<PlotPoint>& points) {
  for (const MethodView& view : method_views(comparison)) {
    if (view.method == jones_pdp7_name || view.method == jones_twin_name || (view.method == montani_re && view.picture == "faces"))
      continue;
    add_point(view, view.method, "", points);
  }
}

bool has_lines(const SceneComparison& comparison, std::string_view method) {
  return std::any_of(comparison.pictures.begin(), comparison.pictures.end(),
                     [method](const ComparedPicture& row) { return row.name == method; });
}

// A setting that the machine cannot hold is left out.
void add_jones(const scene::CellScene& scene, CompareOptions options, const SceneComparison& usual,
               const CompareProgress& progress, std::vector<PlotPoint>& points) {
  const bool guest = has_lines(usual, jones_pdp7_name);
  const bool twin = has_lines(usual, jones_twin_name) && options.host_times;
  options.faces = false;
  options.eye = usual.camera.eye;
  for (const bool eae : {true, false}) {
    options.eae = eae;
    options.methods.clear();
    if (guest) options.methods.emplace_back(jones_pdp7_name);
    if (twin && eae) options.methods.emplace_back(jones_twin_name);
    if (options.methods.empty()) continue;
    for (std::uint32_t bits = 0; bits <= 3; ++bits) {
      options.fraction_bits = bits;
      const std::string label = fmt::format("{} bit{}", bits, bits == 1 ? "" : "s");
      progress(fmt::format("{} {} EAE, {}", jones_pdp7_name, eae ? "with" : "without", label));
      const auto comparison = compare_cell_scene(scene, options);
      if (!comparison) continue;
      for (const MethodView& view : method_views(*comparison)) {
        const bool on_machine = view.method == jones_pdp7_name;
        add_point(view, on_machine ? fmt::format("{} {} EAE", jones_pdp7_name, eae ? "with" : "without") : view.method, label, points);
      }
    }
  }
}

void add_stripes(const scene::PolyScene& scene, const CompareOptions& options, const SceneComparison& usual,
                 const CompareProgress& progress, std::vector<PlotPoint>& points) {
  const scene::PolyCamera& camera = usual.camera;
  const bool there =
      std::any_of(usual.faces.begin(), usual.faces.end(), [](const ComparedFaces& row) { return row.name == montani_re; });
  if (!options.host_times || !there) return;
  const registry::FaceAlgorithm* const algorithm = registry::find_face_algorithm(montani_re);
  const auto truth = FaceTruth::of(scene, camera);
  if (!truth) return;
  for (const double thickness : registry::stripe_thicknesses) {
    // The reference is known at the centres of pixels. Thinner stripes have theirs elsewhere and would be wrong for
    // that alone.
    if (thickness < 1) continue;
    progress(fmt::format("montani-re, stripes of {} px", thickness));
    registry::FaceOptions of_stripe;
    of_stripe.vertical = scene::frame_of(camera).vertical;
    of_stripe.stripe = thickness;
    const auto faces = algorithm->prepare(scene, of_stripe);
    if (!faces) continue;
    auto view = faces->view(camera, truth->window());
    if (!view) continue;
    const double seconds = median_seconds([&] { static_cast<void>(faces->view(camera, truth->window())); });
    const picture::PixelMetrics metrics = truth->compare(std::string(montani_re), std::move(view->faces), 0).metrics;
    points.push_back({PlotPanel::host, "montani-re stripes", fmt::format("{} px", thickness), seconds, 100 * metrics.mismatch()});
  }
}

// --- Plantinga's events

// A turn in even steps, which rarely coincide with an event.
constexpr int turn_frames = 180;
double angle_of(int frame) {
  return -std::numbers::pi + (frame + 0.37) * 2 * std::numbers::pi / turn_frames;
}

// In per cent of the visible length in all frames.
double events_wrong_percent(const plantinga::RotationModel& model, const plantinga::EventList& list, const std::vector<ExactFrame>& frames) {
  const TurnError error = turn_error(model, list, frames);
  // Equal positions computed in different ways differ in their last bits.
  return error.wrong_length > error.seen_length * 1e-12 ? 100 * error.wrong_length / error.seen_length : 0;
}

void add_events(const scene::PolyScene& scene, const CompareOptions& options, const SceneComparison& usual,
                const CompareProgress& progress, std::vector<PlotPoint>& points) {
  constexpr std::size_t most_edges = 400;  // the events of more edges take seconds to find
  if (!options.host_times || !has_lines(usual, "plantinga")) return;
  const plantinga::RotationModel model(scene);
  if (model.edges().size() > most_edges) return;
  std::vector<double> angles;
  for (int i = 0; i < turn_frames; ++i) angles.push_back(angle_of(i));
  const std::vector<ExactFrame> frames = exact_frames(model, angles);
  for (const double degrees : {0.0, 0.1, 1.0, 5.0, 10.0}) {
    const std::string label = degrees == 0 ? "0 degrees" : fmt::format("{} degree{}", degrees, degrees == 1 ? "" : "s");
    progress("plantinga, events within " + label);
    plantinga::BuildOptions build;
    build.tolerance = degrees * std::numbers::pi / 180;
    build.threads = 1;
    const auto list = plantinga::build_event_list(model, build);
    if (!list) return;
    plantinga::EdgeStructureGraph graph(*list);
    plantinga::FrameMaker maker(model);
    std::vector<plantinga::ImageLine> lines;
    const double turn = median_seconds([&] {
      for (int i = 0; i < turn_frames; ++i) {
        static_cast<void>(graph.turn_to(angle_of(i)));
        maker.visible(graph, angle_of(i), lines);
      }
    });
    points.push_back({PlotPanel::host, "plantinga events", label, turn / turn_frames, events_wrong_percent(model, *list, frames)});
  }
}

}  // namespace

std::vector<PlotPoint> variants_of(const scene::CellScene& scene, const CompareOptions& options,
                                   const SceneComparison& comparison, const CompareProgress& progress) {
  std::vector<PlotPoint> points;
  add_jones(scene, options, comparison, progress, points);
  add_plain(comparison, points);
  add_stripes(scene::poly_scene_of(scene), options, comparison, progress, points);
  return points;
}

std::vector<PlotPoint> variants_of(const scene::PolyScene& scene, const CompareOptions& options,
                                   const SceneComparison& comparison, const CompareProgress& progress) {
  std::vector<PlotPoint> points;
  add_plain(comparison, points);
  add_stripes(scene, options, comparison, progress, points);
  add_events(scene, options, comparison, progress, points);
  return points;
}

std::vector<PlotPoint> variants_of(const HeightComparison& comparison) {
  constexpr std::string_view program = "skala-8080";
  std::vector<PlotPoint> points;
  for (const MethodView& view : method_views(comparison)) {
    if (!view.method.starts_with(program)) {
      add_point(view, view.method, "", points);
      continue;
    }
    const std::string_view device = std::string_view(view.method).substr(program.size());
    add_point(view, std::string(program), device.empty() ? "ef9365" : std::string(device.substr(1)), points);
  }
  return points;
}

}  // namespace sightline::compare
