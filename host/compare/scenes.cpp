// See scenes.hpp.
#include "host/compare/scenes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "host/algorithms/oracle/edge_oracle.hpp"
#include "host/algorithms/registry/lines.hpp"
#include "host/base/result.hpp"
#include "host/base/threads.hpp"
#include "host/compare/device_raster.hpp"
#include "host/compare/lines.hpp"
#include "host/compare/stripes.hpp"
#include "host/compare/sweep_views.hpp"
#include "host/compare/willis_8080.hpp"
#include "host/programs/jones/jones.hpp"
#include "host/picture/dots_and_lines.hpp"
#include "host/picture/line_picture_image.hpp"
#include "host/scene/cells/from_cell_scene.hpp"
#include "host/scene/check/crossings.hpp"
#include "host/scene/model/eye_place.hpp"
#include "host/scene/model/file_units.hpp"
#include "host/scene/model/poly_from_cells.hpp"

namespace sightline::compare {
namespace {

namespace oracle = algorithms::oracle;
using base::Error;
using picture::DrawnPiece;
using picture::PixelSegment;
using picture::ReferenceLine;

constexpr double least_stretch = 1;  // pixels, of a difference
constexpr std::string_view bodies_intersect = "bodies intersect";

bool chosen(const CompareOptions& options, std::string_view name) {
  return options.methods.empty() || std::find(options.methods.begin(), options.methods.end(), name) != options.methods.end();
}

// Pictures known to be equal have distance 0, unless their lengths differ.
picture::LineMetrics metrics_of(const std::vector<ReferenceLine>& truth, const std::vector<DrawnPiece>& drawn, const CompareOptions& options,
                                bool identical) {
  if (!options.for_table) return picture::line_metrics(truth, drawn);
  constexpr double noise = 1e-6;  // pixels
  picture::MetricOptions measured;
  measured.points = 0;
  measured.distances = !identical;
  picture::LineMetrics metrics = picture::line_metrics(truth, drawn, measured);
  if (!identical || metrics.symmetric() < noise) return metrics;
  measured.distances = true;
  return picture::line_metrics(truth, drawn, measured);
}

ComparedPicture compare_picture(std::string_view name, std::string rounding, const std::vector<ReferenceLine>& truth,
                         const std::vector<DrawnPiece>& drawn, const CompareOptions& options, bool identical = false) {
  ComparedPicture row{std::string(name), std::move(rounding), std::nullopt, metrics_of(truth, drawn, options, identical), {}};
  if (!options.for_table) row.difference = picture::line_difference(truth, drawn, least_stretch);
  return row;
}

// Adds the algorithms that give the visible face at each point.
void compare_faces(const scene::PolyScene& scene, const CompareOptions& options, const CompareProgress& progress,
                   SceneComparison& comparison) {
  std::vector<const registry::FaceAlgorithm*> algorithms;
  for (const registry::FaceAlgorithm& algorithm : registry::face_algorithms())
    if (chosen(options, algorithm.name)) algorithms.push_back(&algorithm);
  if (chosen(options, willis_on_8080().name)) algorithms.push_back(&willis_on_8080());
  const bool stripes = chosen(options, stripes_name);
  if (algorithms.empty() && !stripes) return;
  progress("oracle of sight lines");
  const auto truth = FaceTruth::of(scene, comparison.camera);
  const bool crossing = !scene::crossings_of(scene, 1).empty();
  for (const registry::FaceAlgorithm* const algorithm : algorithms) {
    const std::string name(algorithm->name);
    if (crossing) {
      comparison.not_applicable.emplace_back(name, bodies_intersect);
      continue;
    }
    if (!truth) {
      comparison.not_applicable.emplace_back(name, truth.error().message());
      continue;
    }
    progress(name);
    auto compared = truth->compare(*algorithm, options.host_times);
    if (!compared)
      comparison.not_applicable.emplace_back(name, compared.error().message());
    else
      comparison.faces.push_back(std::move(*compared));
  }
  if (!stripes) return;
  const std::string name(stripes_name);
  if (crossing || !truth) {
    comparison.not_applicable.emplace_back(name, crossing ? bodies_intersect : truth.error().message());
    return;
  }
  progress(name);
  auto drawn = stripes_faces(scene, comparison.camera, truth->window());
  if (!drawn) {
    comparison.not_applicable.emplace_back(name, drawn.error().message());
    return;
  }
  comparison.stripes_difference = drawn->difference;
  comparison.faces.push_back(truth->compare(name, std::move(drawn->faces), drawn->not_solved));
  comparison.faces.back().counts = {{"faces", drawn->faces_listed}};
  comparison.faces.back().emulated_seconds = drawn->seconds;
  auto pen = stripes_pen(scene, comparison.camera, truth->window(), truth->faces());
  if (pen) comparison.stripes_pen = std::move(*pen);
}

}  // namespace

class SceneMethods::Parts {
 public:
  explicit Parts(CompareOptions options) : options_(std::move(options)) {}

  std::optional<Error> prepare(const scene::CellScene& scene) {
    cells_ = &scene;
    polyhedra_ = scene::poly_scene_of(scene);
    auto matter = MatterScene::of(scene);
    if (!matter) return matter.error();
    matter_.emplace(std::move(*matter));
    if (chosen(options_, jones_pdp7_name) || chosen(options_, jones_twin_name))
      program_.emplace(programs::jones::Prepared::of(scene, {options_.eae, options_.fraction_bits, false}));
    return prepare_algorithms();
  }
  std::optional<Error> prepare(const scene::PolyScene& scene) {
    polyhedra_ = scene;
    return prepare_algorithms();
  }

  base::Result<SceneComparison> view(const scene::PolyCamera& camera, const CompareProgress& progress) const {
    SceneComparison comparison;
    comparison.scene = cells_ != nullptr ? cells_->name : polyhedra_.name;
    comparison.camera = camera;
    comparison.eye = scene::file_point(polyhedra_, camera.eye);
    comparison.not_applicable = not_applicable_;
    if (auto error = outside_error(camera.eye)) return *error;
    if (auto error = compare_lines(comparison, progress)) return *error;
    if (options_.faces) compare_faces(polyhedra_, options_, progress, comparison);
    if (cells_ == nullptr && chosen(options_, turn_name)) compare_turn(comparison, progress);
    return comparison;
  }

  [[nodiscard]] const std::vector<std::pair<std::string, std::string>>& not_applicable() const { return not_applicable_; }

 private:
  struct Entry {
    const registry::LineAlgorithm* algorithm = nullptr;
    registry::PreparedScene prepared;
    bool of_faces = false;  // its picture is one of MatterScene::with_box()
  };

  // The reference of a view.
  struct Truth {
    const scene::PolyScene& scene;
    picture::LinePicture visible;  // for a scene of cells, only within the window of the screen
    std::optional<picture::ChosenEdges> chosen;
    ImageLines lines;
    std::optional<registry::LineView> exact{};  // the view by `exact`, if that is the reference
  };

  std::optional<Error> prepare_algorithms() {
    if (options_.truth_by_exact && !matter_) {
      const registry::LineAlgorithm& exact = registry::line_algorithms().front();
      if (const auto reason = exact.why_not(polyhedra_)) return Error{"", "", *reason};
      auto prepared = exact.prepare(polyhedra_);
      if (!prepared) return prepared.error();
      exact_.emplace(std::move(*prepared));
    }
    const scene::PolyScene& with_faces = matter_ ? matter_->with_box() : polyhedra_;
    const bool crossing = !scene::crossings_of(with_faces, 1).empty();
    for (const registry::LineAlgorithm& algorithm : registry::line_algorithms()) {
      if (algorithm.name == "oracle" || !chosen(options_, algorithm.name)) continue;
      const bool of_cells = matter_ && algorithm.prepare_cells != nullptr;
      if (of_cells) {
        entries_.push_back({&algorithm, algorithm.prepare_cells(scene::complex_of(*cells_, matter_->scene())), false});
        continue;
      }
      const bool of_faces = matter_ && !algorithm.draws_crossings;
      if (crossing && !algorithm.draws_crossings) {
        not_applicable_.emplace_back(algorithm.name, bodies_intersect);
        continue;
      }
      const scene::PolyScene& scene = matter_ && !of_faces ? matter_->scene() : with_faces;
      if (const auto reason = algorithm.why_not(scene)) {
        not_applicable_.emplace_back(algorithm.name, *reason);
        continue;
      }
      auto prepared = algorithm.prepare(scene);
      if (!prepared) return prepared.error();
      entries_.push_back({&algorithm, std::move(*prepared), of_faces});
    }
    return std::nullopt;
  }

  [[nodiscard]] base::Result<Truth> truth_of(SceneComparison& comparison) const {
    const scene::PolyCamera& camera = comparison.camera;
    if (matter_) {
      const scene::PolyScene& scene = matter_->scene();
      comparison.frame = type340_frame(options_.scale);
      auto lines = matter_->lines_at(camera.eye);
      picture::LinePicture visible = matter_->visible(camera.eye, type340_window(options_.scale));
      ImageLines image(visible, scene, camera, comparison.frame, &lines);
      return Truth{scene, std::move(visible), std::move(lines), std::move(image)};
    }
    std::optional<registry::LineView> exact;
    if (exact_) {
      auto view = exact_->view(camera);
      if (!view) return view.error();
      exact = std::move(*view);
    }
    picture::LinePicture visible = exact ? exact->picture : oracle::visible_edges(polyhedra_, camera);
    comparison.frame = fitted_frame(visible, polyhedra_, camera);
    ImageLines image(visible, polyhedra_, camera, comparison.frame);
    return Truth{polyhedra_, std::move(visible), std::nullopt, std::move(image), std::move(exact)};
  }

  std::optional<Error> compare_lines(SceneComparison& comparison, const CompareProgress& progress) const {
    if (auto error = scene::eye_error(polyhedra_, comparison.camera)) return error;
    progress("oracle");
    const auto known = truth_of(comparison);
    if (!known) return known.error();
    const Truth& truth = *known;
    if (matter_)
      if (auto error = compare_programs(truth, comparison, progress)) return error;
    // For a scene of cells the reference is clipped to the screen; exact methods, which see all lines, are compared
    // with the oracle of edges.
    const picture::LinePicture whole = matter_ && !entries_.empty()
                                           ? oracle::visible_edges(truth.scene, comparison.camera, *truth.chosen)
                                           : picture::LinePicture{};
    for (const Entry& entry : entries_) {
      const registry::LineAlgorithm& algorithm = *entry.algorithm;
      progress(algorithm.name);
      if (const auto reason = algorithm.why_not_seen(truth.scene, comparison.camera)) {
        comparison.not_applicable.emplace_back(algorithm.name, *reason);
        continue;
      }
      auto drawn = drawn_by(entry, truth, comparison.camera);
      if (!drawn) return drawn.error();
      const picture::LinePicture& all = matter_ ? whole : truth.visible;
      // Edges with different names may coincide, so a scene of cells is always compared as images.
      const bool identical = matter_ ? picture::image_set(drawn->picture, truth.scene, comparison.camera) ==
                                    picture::image_set(all, truth.scene, comparison.camera)
                              : registry::agrees(algorithm, drawn->picture, all, truth.scene, comparison.camera);
      auto row = compare_picture(algorithm.name, std::string(not_rounded), truth.lines.lines(), truth.lines.pieces(drawn->picture), options_,
                          identical);
      row.identical = identical;
      row.pieces = drawn->picture.pieces.size();
      row.visible_length = picture::image_length(drawn->picture, truth.scene, comparison.camera);
      if (!identical) row.piece_difference = piece_difference(all, drawn->picture);
      row.counts = entry.prepared.counts;
      for (const registry::AlgorithmCount& count : drawn->counts)  // of all cells, and of those a view enters
        row.counts.push_back({count.name == "cells" ? "cells_read" : count.name, count.value});
      if (options_.host_times)
        row.host_seconds =
            median_seconds([&] { static_cast<void>(view_of(entry, truth, comparison.camera)); }, options_.host_seconds);
      comparison.pictures.push_back(std::move(row));
    }
    return std::nullopt;
  }

  [[nodiscard]] static base::Result<registry::LineView> view_of(const Entry& entry, const Truth& truth, const scene::PolyCamera& camera) {
    return truth.chosen && !entry.of_faces ? registry::view_of(entry.prepared, camera, *truth.chosen) : entry.prepared.view(camera);
  }

  // Converts to a picture of the reference's scene.
  [[nodiscard]] base::Result<registry::LineView> drawn_by(const Entry& entry, const Truth& truth, const scene::PolyCamera& camera) const {
    if (truth.exact && entry.algorithm == &registry::line_algorithms().front()) return *truth.exact;
    auto view = view_of(entry, truth, camera);
    if (view && entry.of_faces) view->picture = matter_->on_lines(view->picture, camera.eye);
    return view;
  }

  // Compares Jones's program on its machine, and its twin.
  std::optional<Error> compare_programs(const Truth& truth, SceneComparison& comparison, const CompareProgress& progress) const {
    const bool guest_row = chosen(options_, jones_pdp7_name);
    const bool twin_row = chosen(options_, jones_twin_name);
    if (!guest_row && !twin_row) return std::nullopt;
    progress(jones_pdp7_name);
    const auto place = programs::jones::viewpoint(*cells_, comparison.camera.eye);
    if (!place) return leave_programs_out(place.error(), comparison);
    if (!*program_) return leave_programs_out(program_->error(), comparison);
    programs::jones::Order order;
    order.eye = comparison.camera.eye;
    order.scale = options_.scale;
    order.views = 1;
    return compare_program(**program_, order, truth, comparison);
  }

  // The reference of a scene of cells is known within its outer box.
  [[nodiscard]] std::optional<Error> outside_error(const geometry::Point& eye) const {
    if (cells_ == nullptr) return std::nullopt;
    for (std::size_t a = 0; a < 3; ++a)
      if (eye[a] <= cells_->outer.low[a] || eye[a] >= cells_->outer.high[a])
        return Error{"", "eye", fmt::format("{},{},{}, outside of the outer box", eye[0], eye[1], eye[2]),
                     fmt::format("a point within {},{},{} and {},{},{}", cells_->outer.low[0], cells_->outer.low[1], cells_->outer.low[2],
                                 cells_->outer.high[0], cells_->outer.high[1], cells_->outer.high[2])};
    return std::nullopt;
  }

  // The program cannot use the eye, or its core cannot hold the scene. Other methods can, for an eye within the outer
  // box.
  std::optional<Error> leave_programs_out(const Error& why, SceneComparison& comparison) const {
    for (const std::string_view name : {jones_pdp7_name, jones_twin_name})
      if (chosen(options_, name)) comparison.not_applicable.emplace_back(name, why.message());
    return std::nullopt;
  }

  std::optional<Error> compare_program(const programs::jones::Prepared& program, const programs::jones::Order& order, const Truth& truth,
                                       SceneComparison& comparison) const {
    const auto outcome = program.run(order);
    if (!outcome) return outcome.error();
    const auto twin = program.twin(order);
    if (!twin) return twin.error();
    const programs::jones::View& view = outcome->view();
    comparison.guest = {view.status, view.time, view.display_file.size(), programs::jones::difference_of(view, *twin)};

    const auto lines = lines_of_vectors(program.program().scene, *matter_, truth.lines);
    if (chosen(options_, jones_pdp7_name)) {
      if (comparison.guest->difference.empty()) {
        const auto drawn = display_pieces(*twin, lines, static_cast<int>(options_.fraction_bits));
        auto row = compare_picture(jones_pdp7_name, "points", truth.lines.lines(), drawn, options_);
        const auto seen = visible_segments(truth.lines.lines());
        row.metrics.hausdorff = picture::hausdorff_distance(seen, picture::dot_segments(points_of(outcome->pass)));
        row.emulated = view.time;
        row.counts = {{"cells_read", view.distinct_cells}, {"cells", cells_->cells.size()}, {"visits", view.visits},
                      {"openings_tested", view.openings_tested}, {"lines_clipped", view.lines_clipped}};
        std::vector<PixelSegment> vectors;
        for (const DrawnPiece& piece : drawn) vectors.push_back(piece.image);
        ComparedFlashes flashes = compare_flashes(seen, vectors, outcome->pass);
        row.lit = std::move(flashes.shown);
        row.lit_in_truth = std::move(flashes.truth);
        row.raster = flashes.difference;
        comparison.pictures.push_back(std::move(row));
      } else {
        comparison.not_applicable.emplace_back(
            jones_pdp7_name, "its display file differs from its twin's, so its vectors cannot be assigned to lines: " + comparison.guest->difference);
      }
    }
    if (chosen(options_, jones_twin_name)) {
      const int parts = 1 << options_.fraction_bits;
      auto row = compare_picture(jones_twin_name, parts == 1 ? "points" : fmt::format("1/{} point", parts), truth.lines.lines(),
                          twin_pieces(*twin, lines, static_cast<int>(options_.fraction_bits)), options_);
      const programs::jones::TwinCounts& c = twin->counts;
      row.counts = {{"cells_read", c.distinct_cells}, {"cells", cells_->cells.size()}, {"visits", c.visits}, {"openings_tested", c.openings_tested}, {"lines_clipped", c.lines_clipped}};
      if (options_.host_times) {
        const auto core = program.core_at(comparison.camera.eye);
        const auto view_once = [&] { static_cast<void>(programs::jones::run_twin(program.program(), *core, order)); };
        row.host_seconds = median_seconds(view_once, options_.host_seconds);
      }
      comparison.pictures.push_back(std::move(row));
    }
    return std::nullopt;
  }

  void compare_turn(SceneComparison& comparison, const CompareProgress& progress) const {
    const auto angle = turn_angle_of(comparison.camera);
    if (!angle) {
      if (!options_.methods.empty())
        comparison.not_applicable.emplace_back(turn_name, "draws in parallel projection along a level direction only");
      return;
    }
    progress(turn_name);
    const auto& turning = turning_of();
    auto checked = turning ? check_turn(*turning, *angle) : base::Result<TurnCheck>(turning.error());
    if (checked)
      comparison.turn = std::move(*checked);
    else
      comparison.not_applicable.emplace_back(turn_name, checked.error().message());
  }

  // The scene on its machine, prepared for the first view that needs it.
  const base::Result<Turning>& turning_of() const {
    const base::Lock lock(turning_mutex_);
    if (!turning_) turning_.emplace(Turning::of(polyhedra_));
    return *turning_;
  }

  CompareOptions options_;
  const scene::CellScene* cells_ = nullptr;
  scene::PolyScene polyhedra_;
  std::optional<MatterScene> matter_;  // for a scene of cells
  std::optional<base::Result<programs::jones::Prepared>> program_;  // if requested
  std::vector<Entry> entries_;
  std::optional<registry::PreparedScene> exact_;  // computes the reference
  mutable base::Mutex turning_mutex_;
  mutable std::optional<base::Result<Turning>> turning_;
  std::vector<std::pair<std::string, std::string>> not_applicable_;
};

SceneMethods::SceneMethods(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
SceneMethods::SceneMethods(SceneMethods&&) noexcept = default;
SceneMethods& SceneMethods::operator=(SceneMethods&&) noexcept = default;
SceneMethods::~SceneMethods() = default;

base::Result<SceneMethods> SceneMethods::of(const scene::CellScene& scene, const CompareOptions& options) {
  auto parts = std::make_unique<Parts>(options);
  if (auto error = parts->prepare(scene)) return *error;
  return SceneMethods(std::move(parts));
}

base::Result<SceneMethods> SceneMethods::of(const scene::PolyScene& scene, const CompareOptions& options) {
  auto parts = std::make_unique<Parts>(options);
  if (auto error = parts->prepare(scene)) return *error;
  return SceneMethods(std::move(parts));
}

base::Result<SceneComparison> SceneMethods::view(const scene::PolyCamera& camera, const CompareProgress& progress) const {
  return parts_->view(camera, progress);
}

const std::vector<std::pair<std::string, std::string>>& SceneMethods::not_applicable() const {
  return parts_->not_applicable();
}

std::optional<std::string> why_not_applicable(std::string_view method, SceneKind kind) {
  const bool skala = method.starts_with("skala");
  if (kind == SceneKind::function)
    return skala ? std::nullopt : std::optional<std::string>("it draws scenes, not functions of two variables");
  if (skala) return "it draws functions of two variables, such as sinc";
  if (method.starts_with("jones-") && kind != SceneKind::cells) return "Jones's program takes scenes of cells, looking along +z";
  if (method == turn_name && kind == SceneKind::cells) return "it takes polyhedra; --level takes a scene of cells as polyhedra";
  return std::nullopt;
}

std::vector<std::string> method_names() {
  std::vector<std::string> names{std::string(jones_pdp7_name), std::string(jones_twin_name)};
  const auto add = [&names](std::string_view name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.emplace_back(name);
  };
  for (const registry::LineAlgorithm& algorithm : registry::line_algorithms())
    if (algorithm.name != "oracle") add(algorithm.name);
  for (const registry::FaceAlgorithm& algorithm : registry::face_algorithms()) add(algorithm.name);
  add(willis_on_8080().name);
  add(stripes_name);
  add(turn_name);
  for (const char* const skala : {"skala-8080", "skala-twin", "skala"}) add(skala);  // for functions: answer.hpp
  return names;
}

bool SceneComparison::agrees() const {
  return std::none_of(pictures.begin(), pictures.end(),
                      [](const ComparedPicture& p) { return p.identical && !*p.identical; }) &&
         std::all_of(faces.begin(), faces.end(), [](const ComparedFaces& f) { return f.agrees(); }) &&
         (!guest || guest->difference.empty()) && stripes_difference.empty() && (!stripes_pen || stripes_pen->difference.empty()) && (!turn || turn->agrees());
}

base::Result<SceneComparison> compare_cell_scene(const scene::CellScene& scene, const CompareOptions& options,
                                                 const CompareProgress& progress) {
  const auto methods = SceneMethods::of(scene, options);
  if (!methods) return methods.error();
  scene::PolyCamera camera;
  camera.eye = options.eye.value_or(scene.default_view);
  return methods->view(camera, progress);
}

base::Result<SceneComparison> compare_poly_scene(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                                                 const CompareOptions& options, const CompareProgress& progress) {
  const auto methods = SceneMethods::of(scene, options);
  if (!methods) return methods.error();
  return methods->view(camera, progress);
}

}  // namespace sightline::compare
