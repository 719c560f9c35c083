#include "host/report/speed_error/jones.hpp"

#include <fmt/format.h>

#include <array>
#include <functional>
#include <utility>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/jones/visible_edges.hpp"
#include "host/algorithms/oracle/edge_oracle.hpp"
#include "host/guests/jones/precision/guest_pieces.hpp"
#include "host/report/speed_error/clock.hpp"
#include "host/scene/cells/from_cell_scene.hpp"
#include "host/scene/model/poly_from_cells.hpp"

namespace sightline::harness::report {

namespace {

constexpr int most_machine_fraction = 3;  // fraction bits
constexpr std::array tried_lengths{12, 14, 16, 18, 20, 22, 24, 28, 32, 36};

double seconds(core::Duration time) {
  return core::in_seconds(time);
}

using Lines = std::vector<std::optional<guests::jones::SceneLine>>;

struct GuestView {
  guests::jones::GuestPieces pieces;
  Lines lines;  // of its vector words
};

Outcome<GuestView> run_guest(const SceneViews& views, std::size_t view, const guests::jones::Precision& build,
                             bool eae) {
  guests::jones::ProgramOptions options;
  options.eae = eae;
  options.fraction_bits = static_cast<std::uint32_t>(build.fraction_bits);
  options.truncate = build.truncate;
  options.tape.view = views.eye(view);
  const auto assembled = guests::jones::assemble_program(views.scene(), options);
  if (!assembled) return ReportError{ErrorKind::bad_input, views.name() + ": " + assembled.error().message()};
  const auto& program = *assembled;
  const std::vector<core::Word18>& words = program.core;
  GuestView run{guests::jones::run_for_pieces(program, eae),
                guests::jones::lines_by_address(program.scene, words)};
  if (run.pieces.status != guests::jones::Status::complete)
    return ReportError{ErrorKind::guest_failed, fmt::format("{}, {}: the view stopped: {}", views.name(),
                                                            name(build), name(run.pieces.status))};
  return run;
}

// Program and scene lie elsewhere without the EAE: the pieces of the same lines in the same places.
bool same_pieces(const GuestView& a, const GuestView& b) {
  if (a.pieces.clipped.size() != b.pieces.clipped.size()) return false;
  for (std::size_t i = 0; i < a.pieces.clipped.size(); ++i) {
    const guests::jones::Piece& here = a.pieces.clipped[i];
    const guests::jones::Piece& there = b.pieces.clipped[i];
    if (here.line != there.line || here.drawn != there.drawn ||
        a.lines.at(here.vector_address) != b.lines.at(there.vector_address))
      return false;
  }
  return true;
}

void add_guest(MachineBuild& build, const SceneViews& views, std::size_t view, const GuestView& run) {
  const guests::jones::ShortWords number(guests::jones::machine_word_bits, build.precision.fraction_bits,
                                         build.precision.truncate);
  const guests::jones::Window window;
  const auto x = [&](std::int32_t units) { return number.points(units) + window.centre_x; };
  const auto y = [&](std::int32_t units) { return number.points(units) + window.centre_y; };
  std::vector<picture::DrawnPiece> clipped;
  std::vector<picture::DrawnPiece> displayed;
  for (std::size_t i = 0; i < run.pieces.clipped.size(); ++i) {
    const auto& line = run.lines.at(run.pieces.clipped[i].vector_address);
    if (!line) continue;
    const guests::jones::ScreenSegment& at = run.pieces.clipped[i].line;
    clipped.push_back(views.piece(view, *line, {x(at.a.x), y(at.a.y), x(at.b.x), y(at.b.y)}));
    if (!run.pieces.clipped[i].drawn) continue;
    const guests::jones::ScreenSegment& shown = run.pieces.on_display.at(i);
    const auto point = [](std::int32_t place) { return static_cast<double>(place); };
    displayed.push_back(
        views.piece(view, *line, {point(shown.a.x), point(shown.a.y), point(shown.b.x), point(shown.b.y)}));
  }
  views.add(build.clipped, view, run.pieces.status, clipped);
  views.add(build.displayed, view, run.pieces.status, displayed);
}

guests::jones::PreciseView run_twin(const SceneViews& views, std::size_t view,
                                    const guests::jones::Precision& precision) {
  const auto& core = views.in_core(view).core;
  return guests::jones::run_precisely(core, 0, guests::jones::default_parameters(core, 0), precision);
}

// The most fraction bits with which every view is complete; 0 if none are.
int most_complete(const SceneViews& views, int word_bits) {
  for (int f = guests::jones::most_fraction_bits; f > 0; --f) {
    const guests::jones::Precision precision{guests::jones::NumberKind::fixed_point, word_bits, f, false};
    bool complete = true;
    for (std::size_t view = 0; view < views.size() && complete; ++view)
      complete = run_twin(views, view, precision).status == guests::jones::Status::complete;
    if (complete) return f;
  }
  return 0;
}

void measure_twins(const SceneViews& views, JonesMeasured& measured) {
  for (const bool truncate : {false, true}) {
    for (int f = 0; f <= guests::jones::most_fraction_bits; ++f)
      measured.fractions.push_back(measure_twin(
          views, {guests::jones::NumberKind::fixed_point, guests::jones::longest_word, f, truncate}));
  }
  for (const int bits : tried_lengths)
    measured.words.push_back(measure_twin(
        views, {guests::jones::NumberKind::fixed_point, bits, most_complete(views, bits), false}));
  for (const auto kind : {guests::jones::NumberKind::single_float, guests::jones::NumberKind::double_float})
    measured.floating.push_back(measure_twin(views, {kind}));
}

// What draws a scene exactly.
struct ExactScene {
  scene::PolyScene polyhedra;
  scene::CellComplex complex;
  algorithms::jones::PreparedComplex prepared;
  algorithms::jones::Walker walker;
  algorithms::exact::EdgeMesh mesh;
  std::vector<scene::PolyCamera> cameras;

  explicit ExactScene(const SceneViews& views)
      : polyhedra(scene::poly_scene_of(views.scene())),
        complex(scene::complex_of(views.scene(), polyhedra)),
        prepared(complex),
        walker(prepared),
        mesh(algorithms::exact::make_edge_mesh(polyhedra)) {
    for (std::size_t i = 0; i < views.size(); ++i) {
      cameras.push_back(polyhedra.camera);
      cameras.back().eye = views.eye(i);
    }
  }

  // Every view has a picture: guests::jones::Walker gives none for an eye in a solid.
  [[nodiscard]] std::optional<picture::LinePicture> by_jones(std::size_t view) {
    auto seen = walker.visible_edges(cameras[view]);
    if (!seen) return std::nullopt;
    return std::move(seen->picture);
  }
  [[nodiscard]] picture::LinePicture by_edges(std::size_t view) const {
    return algorithms::exact::visible_edges(mesh, cameras[view]);
  }
  [[nodiscard]] picture::LinePicture by_oracle(std::size_t view) const {
    return algorithms::oracle::visible_edges(polyhedra, cameras[view]);
  }
};

std::optional<ReportError> check_exact(ExactScene& scene, const std::string& name) {
  for (std::size_t view = 0; view < scene.cameras.size(); ++view) {
    const picture::LinePicture truth = scene.by_oracle(view);
    if (scene.by_jones(view) != truth || scene.by_edges(view) != truth)
      return ReportError{
          ErrorKind::differs,
          fmt::format("{}, view {}: internal error: an exact algorithm does not draw what the oracle finds",
                      name, view + 1)};
  }
  return std::nullopt;
}

// Interleaved over all arithmetic of a scene, six views a job.
void time_scene(const SceneViews& views, ExactScene& exact, JonesMeasured& measured, int rounds) {
  std::vector<std::function<void()>> jobs;
  std::vector<std::optional<double>*> results;
  const auto add = [&](std::optional<double>& result, auto&& view) {
    results.push_back(&result);
    jobs.emplace_back([&views, view] {
      for (std::size_t i = 0; i < views.size(); ++i) view(i);
    });
  };
  for (auto* const twins : {&measured.fractions, &measured.words, &measured.floating}) {
    for (Twin& twin : *twins)
      add(twin.view_ns, [&views, &twin](std::size_t i) { (void)run_twin(views, i, twin.precision); });
  }
  add(measured.exact[0].view_ns, [&exact](std::size_t i) { (void)exact.by_jones(i); });
  add(measured.exact[1].view_ns, [&exact](std::size_t i) { (void)exact.by_edges(i); });
  add(measured.exact[2].view_ns, [&exact](std::size_t i) { (void)exact.by_oracle(i); });
  const auto times = median_nanoseconds(jobs, rounds);
  for (std::size_t i = 0; i < jobs.size(); ++i) *results[i] = times[i] / static_cast<double>(views.size());
}

Outcome<JonesMeasured> measure_scene(const SceneViews& views, const Context& context) {
  JonesMeasured measured;
  measured.scene = views.name();
  context.progress(fmt::format("{} on the PDP-7 in every arithmetic", views.name()));
  for (const bool truncate : {false, true}) {
    for (int f = 0; f <= most_machine_fraction; ++f) {
      auto build = measure_build(
          views, {guests::jones::NumberKind::fixed_point, guests::jones::machine_word_bits, f, truncate});
      if (!build) return std::move(build.error());
      measured.machine.push_back(std::move(*build));
    }
  }
  context.progress(fmt::format("{} in C++ in every arithmetic", views.name()));
  measure_twins(views, measured);
  ExactScene exact(views);
  if (auto error = check_exact(exact, views.name())) return std::move(*error);
  measured.exact = {{"Jones, exact", {}}, {"exact visible edges", {}}, {"oracle", {}}};
  if (context.host_times) time_scene(views, exact, measured, context.full ? 61 : 15);
  return measured;
}

}  // namespace

Outcome<MachineBuild> measure_build(const SceneViews& views, const guests::jones::Precision& precision) {
  MachineBuild build;
  build.precision = precision;
  for (std::size_t view = 0; view < views.size(); ++view) {
    auto with = run_guest(views, view, precision, true);
    if (!with) return std::move(with.error());
    auto without = run_guest(views, view, precision, false);
    if (!without) return std::move(without.error());
    const auto& eae = *with;
    const auto& plain = *without;
    if (!same_pieces(eae, plain))
      return ReportError{ErrorKind::differs, fmt::format("{}, {}: internal error: the program draws other "
                                                         "pieces with the EAE than without",
                                                         views.name(), name(precision))};
    add_guest(build, views, view, eae);
    build.eae_s += seconds(eae.pieces.time) / static_cast<double>(views.size());
    build.plain_s += seconds(plain.pieces.time) / static_cast<double>(views.size());
  }
  return build;
}

Twin measure_twin(const SceneViews& views, const guests::jones::Precision& precision) {
  Twin twin;
  twin.precision = precision;
  for (std::size_t view = 0; view < views.size(); ++view) {
    const guests::jones::PreciseView seen = run_twin(views, view, precision);
    std::vector<picture::DrawnPiece> drawn;
    for (const guests::jones::PrecisePiece& piece : seen.pieces) {
      if (const auto& line = views.in_core(view).lines.at(piece.vector_address))
        drawn.push_back(views.piece(view, *line, piece.line));
    }
    views.add(twin.error, view, seen.status, drawn);
  }
  return twin;
}

Outcome<std::vector<JonesMeasured>> measure_jones(const Context& context) {
  std::vector<JonesMeasured> scenes;
  for (const guests::jones::SixViews& six : guests::jones::six_views) {
    const auto views = SceneViews::of(six);
    if (!views) return views.error();
    auto measured = measure_scene(*views, context);
    if (!measured) return std::move(measured.error());
    scenes.push_back(std::move(*measured));
  }
  return scenes;
}

}  // namespace sightline::harness::report
