#include "host/report/experiments/jones_pictures.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "host/algorithms/oracle/matter.hpp"
#include "host/algorithms/oracle/visible_lines.hpp"
#include "host/base/value_of.hpp"
#include "host/programs/jones/jones.hpp"
#include "host/report/experiment.hpp"
#include "host/scene/read/cell_scene.hpp"

namespace sightline::report {

namespace {

namespace jones = programs::jones;
namespace jones_precision = compare::jones_precision;
namespace oracle = algorithms::oracle;

// Tried in each view: 24,000 per scene, of which more than 10,000 are farther than a pixel from a change of
// visibility.
constexpr std::uint64_t points_a_view = 4000;

using Lines = std::vector<std::optional<jones_precision::SceneLine>>;

struct MachineView {
  jones::View view;
  Lines lines;  // of its vector words
};

MachineView run_on_machine(const SceneViews& views, std::size_t view, const jones_precision::Precision& build, bool eae) {
  const auto program = base::value_of(
      jones::Prepared::of(views.scene(), {eae, static_cast<std::uint32_t>(build.fraction_bits), build.truncate}), views.name());
  jones::Order order;
  order.eye = views.eye(view);
  order.clock = false;
  order.views = 1;
  order.display = false;
  order.pieces = true;
  auto outcome = base::value_of(program.run(order), views.name());
  MachineView run{std::move(outcome.views.front()), jones_precision::lines_by_address(program.program().scene, program.program().core)};
  if (run.view.status != jones::Status::complete)
    throw base::program_failed(fmt::format("{}, {}: the view stopped: {}", views.name(), name(build), name(run.view.status)));
  return run;
}

// Program and scene are at other addresses without the EAE; compares pieces of the same lines in the same places.
bool same_pieces(const MachineView& a, const MachineView& b) {
  if (a.view.clipped.size() != b.view.clipped.size()) return false;
  for (std::size_t i = 0; i < a.view.clipped.size(); ++i) {
    const jones::Piece& here = a.view.clipped[i];
    const jones::Piece& there = b.view.clipped[i];
    if (here.line != there.line || here.drawn != there.drawn ||
        a.lines.at(here.vector_address) != b.lines.at(there.vector_address))
      return false;
  }
  return true;
}

void add_machine(MachineBuild& build, const SceneViews& views, std::size_t view, const MachineView& run) {
  const jones::ShortWords number(jones::machine_word_bits, build.precision.fraction_bits,
                                         build.precision.truncate);
  const jones::Window window;
  const auto x = [&](std::int32_t units) { return number.points(units) + window.centre_x; };
  const auto y = [&](std::int32_t units) { return number.points(units) + window.centre_y; };
  std::vector<picture::DrawnPiece> clipped;
  std::vector<picture::DrawnPiece> displayed;
  for (std::size_t i = 0; i < run.view.clipped.size(); ++i) {
    const auto& line = run.lines.at(run.view.clipped[i].vector_address);
    if (!line) continue;
    const jones::ScreenSegment& at = run.view.clipped[i].line;
    clipped.push_back(views.piece(view, *line, {x(at.a.x), y(at.a.y), x(at.b.x), y(at.b.y)}));
    if (!run.view.clipped[i].drawn) continue;
    const jones::ScreenSegment& shown = run.view.on_display.at(i);
    const auto point = [](std::int32_t place) { return static_cast<double>(place); };
    displayed.push_back(
        views.piece(view, *line, {point(shown.a.x), point(shown.a.y), point(shown.b.x), point(shown.b.y)}));
  }
  views.add(build.clipped, view, run.view.status, clipped);
  views.add(build.displayed, view, run.view.status, displayed);
}

}  // namespace

SceneViews::SceneViews(const jones_precision::SixViews& views) : name_(views.scene) {
  auto scene = scene::load_cell_scene(name_);
  if (!scene) throw base::bad_input(scene.error().message());
  scene_ = *std::move(scene);
  auto matter = compare::MatterScene::of(scene_);
  if (!matter) throw base::bad_input(fmt::format("{}: {}", name_, matter.error().message()));
  matter_ = std::make_unique<const compare::MatterScene>(std::move(*matter));
  for (const geometry::Point& eye : views.eyes) {
    auto in_core = jones_precision::scene_in_core(scene_, eye);
    if (!in_core) throw base::bad_input(fmt::format("{}: {}", name_, in_core.error().message()));
    scene::PolyCamera camera;
    camera.eye = eye;
    const auto lines = matter_->lines_at(eye);
    views_.push_back({eye, *std::move(in_core), {matter_->visible(eye, compare::type340_window()), matter_->scene(), camera, compare::type340_frame(), &lines}});
  }
}

picture::DrawnPiece SceneViews::piece(std::size_t view, const jones_precision::SceneLine& line,
                                      const algorithms::oracle::ScreenSegment& image) const {
  const auto [u, v] = geometry::other_axes(line.axis);
  const compare::AxisLine of{line.axis, {line.from[u], line.from[v]}};
  const picture::LineEdge none;  // in no scene
  return {views_[view].reference.line_of(matter_->wire_on(of).value_or(none)), {{image.x0, image.y0}, {image.x1, image.y1}}};
}

void SceneViews::add(PictureError& error, std::size_t view, jones::Status status,
                     const std::vector<picture::DrawnPiece>& drawn) const {
  const auto metrics =
      picture::line_metrics(views_[view].reference.lines(), drawn, {.points = points_a_view, .seed = 1971});
  error.visible += metrics.true_length;
  error.missing += metrics.missing;
  error.extra += metrics.extra;
  error.extra_far += metrics.extra_far;
  error.hausdorff = std::max(error.hausdorff, metrics.hausdorff.greatest);
  error.wrong_visibility = picture::rate_of(error.wrong_visibility.wrong + metrics.wrong_visibility.wrong,
                                            error.wrong_visibility.points + metrics.wrong_visibility.points);
  error.incomplete += status == jones::Status::complete ? 0 : 1;
}

MachineBuild measure_build(const SceneViews& views, const jones_precision::Precision& precision) {
  MachineBuild build;
  build.precision = precision;
  for (std::size_t view = 0; view < views.size(); ++view) {
    const MachineView eae = run_on_machine(views, view, precision, true);
    const MachineView plain = run_on_machine(views, view, precision, false);
    if (!same_pieces(eae, plain))
      throw base::difference(fmt::format("{}, {}: internal error: the program draws other pieces with the EAE than without",
                                views.name(), name(precision)));
    add_machine(build, views, view, eae);
    build.eae_s += core::in_seconds(eae.view.time) / static_cast<double>(views.size());
    build.plain_s += core::in_seconds(plain.view.time) / static_cast<double>(views.size());
  }
  return build;
}

jones_precision::PreciseView run_twin(const SceneViews& views, std::size_t view, const jones_precision::Precision& precision) {
  const auto& core = views.in_core(view).core;
  return jones_precision::run_precisely(core, 0, jones::default_parameters(core, 0), precision);
}

PictureError measure_twin(const SceneViews& views, const jones_precision::Precision& precision) {
  PictureError error;
  for (std::size_t view = 0; view < views.size(); ++view) {
    const jones_precision::PreciseView seen = run_twin(views, view, precision);
    std::vector<picture::DrawnPiece> drawn;
    for (const jones_precision::PrecisePiece& piece : seen.pieces)
      if (const auto& line = views.in_core(view).lines.at(piece.vector_address))
        drawn.push_back(views.piece(view, *line, piece.line));
    views.add(error, view, seen.status, drawn);
  }
  return error;
}

}  // namespace sightline::report
