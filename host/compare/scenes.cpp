// See scenes.hpp.
#include "host/compare/scenes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <utility>
#include <vector>

#include "host/algorithms/oracle/edge_oracle.hpp"
#include "host/algorithms/oracle/matter.hpp"
#include "host/algorithms/registry/lines.hpp"
#include "host/base/result.hpp"
#include "host/compare/lines.hpp"
#include "host/compare/stripes.hpp"
#include "host/compare/willis_8080.hpp"
#include "host/guests/jones/session.hpp"
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

constexpr double least_stretch = 1;  // pixels, in a difference

ComparedPicture compared(std::string name, std::string what, const std::vector<ReferenceLine>& truth,
                         const std::vector<DrawnPiece>& drawn) {
  return {std::move(name), std::move(what), std::nullopt, picture::line_metrics(truth, drawn),
          picture::line_difference(truth, drawn, least_stretch)};
}

// exact algorithms

ComparedPicture compared_by_image(const std::string& name, const std::vector<ReferenceLine>& lines,
                                  const std::vector<DrawnPiece>& pieces, const scene::PolyScene& scene,
                                  const scene::PolyCamera& camera) {
  const ImageLines together(lines, scene, camera);
  return compared(name, "exact pieces, of edges that lie on each other in the image once", together.lines(),
                  together.pieces(pieces));
}

constexpr const char* bodies_intersect = "bodies intersect";

// Adds a picture for every algorithm of the table but the oracle's own.
std::optional<base::Error> compare_algorithms(const scene::PolyScene& scene, const CompareProgress& progress,
                                              const std::optional<ScreenFrame>& frame,
                                              SceneComparison& comparison) {
  const scene::PolyCamera& camera = comparison.camera;
  if (auto error = scene::eye_error(scene, camera)) return error;
  progress("oracle");
  const picture::LinePicture truth = oracle::visible_edges(scene, camera);
  comparison.frame = frame ? *frame : fitted_frame(truth, scene, camera);
  const auto lines = reference_lines(truth, scene, camera, comparison.frame);
  const bool crossing = !scene::crossings_of(scene, 1).empty();
  for (const registry::LineAlgorithm& algorithm : registry::line_algorithms()) {
    if (algorithm.name == "oracle") continue;
    const std::string name(algorithm.name);
    progress(name);
    if (crossing && !algorithm.draws_crossings) {
      comparison.not_applicable.emplace_back(name, bodies_intersect);
      continue;
    }
    if (const auto reason = algorithm.why_not(scene)) {
      comparison.not_applicable.emplace_back(name, *reason);
      continue;
    }
    if (const auto reason = algorithm.why_not_seen(scene, camera)) {
      comparison.not_applicable.emplace_back(name, *reason);
      continue;
    }
    const auto prepared = algorithm.prepare(scene);
    if (!prepared) return prepared.error();
    const auto view = prepared->view(camera);
    if (!view) return view.error();
    const picture::LinePicture& drawn = view->picture;
    const auto pieces = drawn_pieces(drawn, scene, camera, comparison.frame);
    auto row = algorithm.same_by_image ? compared_by_image(name, lines, pieces, scene, camera)
                                       : compared(name, "exact pieces of the scene's edges", lines, pieces);
    row.identical = agrees(algorithm, drawn, truth, scene, camera);
    comparison.pictures.push_back(std::move(row));
  }
  return std::nullopt;
}

// Adds the algorithms that say which face is seen at each point.
void compare_faces(const scene::PolyScene& scene, const CompareProgress& progress,
                   SceneComparison& comparison) {
  progress("oracle of sight lines");
  const auto truth = FaceTruth::of(scene, comparison.camera);
  const bool crossing = !scene::crossings_of(scene, 1).empty();
  std::vector<const registry::FaceAlgorithm*> algorithms;
  for (const registry::FaceAlgorithm& algorithm : registry::face_algorithms()) algorithms.push_back(&algorithm);
  algorithms.push_back(&willis_on_8080());
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
    auto compared = truth->compared(*algorithm);
    if (!compared)
      comparison.not_applicable.emplace_back(name, compared.error().message());
    else
      comparison.faces.push_back(std::move(*compared));
  }
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
  comparison.faces.push_back(truth->compared(name, std::move(drawn->faces), drawn->not_solved));
}

// guest and twin

// Every point that is lit in one pass.
std::vector<PixelSegment> lit_points(const std::vector<core::Stroke>& pass) {
  std::vector<std::pair<std::uint16_t, std::uint16_t>> places;
  for (const core::Stroke& stroke : pass) places.emplace_back(stroke.x, stroke.y);
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  std::vector<PixelSegment> points;
  for (const auto& [x, y] : places) {
    const picture::PixelPoint point{static_cast<double>(x), static_cast<double>(y)};
    points.push_back({point, point});
  }
  return points;
}

std::vector<PixelSegment> seen_segments(const std::vector<ReferenceLine>& lines) {
  std::vector<PixelSegment> segments;
  for (const ReferenceLine& line : lines) {
    for (const picture::LinePart& part : line.visible) {
      const auto at = [&](double place) {
        return picture::PixelPoint{line.image.a.x + place * (line.image.b.x - line.image.a.x),
                                   line.image.a.y + place * (line.image.b.y - line.image.a.y)};
      };
      segments.push_back({at(part.low), at(part.high)});
    }
  }
  return segments;
}

// The guest's and the twin's pictures, first and second.
std::optional<base::Error> compare_programs(const scene::CellScene& scene, const CompareOptions& options,
                                            const CompareProgress& progress, SceneComparison& comparison) {
  guests::jones::ProgramOptions of_program;
  of_program.eae = options.eae;
  of_program.tape.view = comparison.camera.eye;
  const auto session = guests::jones::Session::of(scene, of_program);
  if (!session) return session.error();
  const auto matter = oracle::Matter::of(scene);
  if (!matter) return base::Error{"", "", "is too large for the oracle"};

  progress("cell oracle");
  oracle::Window window;
  window.scale = options.scale;
  window.near = guests::jones::near_z;
  const auto real_lines = matter->real_lines();
  const CellReference reference(real_lines,
                                oracle::visible_lines(*matter, real_lines, comparison.camera.eye, window),
                                comparison.camera.eye, window);

  progress("guest and twin");
  guests::jones::GuestOptions of_guest;
  of_guest.scale = options.scale;
  of_guest.views = 1;
  const guests::jones::CheckedRun run = session->run(of_guest);
  if (run.guest.timed_out || run.guest.views.empty())
    return base::Error{"", "", "the program on the PDP-7 did not complete a view"};
  const guests::jones::GuestView& guest = run.guest.views.back();
  comparison.guest = {guest.status, guest.time, guest.display_file.size(), run.difference};

  const auto vectors = lines_of_vectors(session->program().scene);
  if (comparison.guest->difference.empty()) {
    auto row = compared("guest", "display vectors; distance of the points lit", reference.lines(),
                        display_pieces(run.twin, vectors, reference));
    row.metrics.hausdorff =
        picture::hausdorff_distance(seen_segments(reference.lines()), lit_points(run.guest.pass));
    comparison.pictures.push_back(std::move(row));
  } else {
    comparison.not_applicable.emplace_back(
        "guest",
        "its display file is not its twin's, so its vectors have no lines: " + comparison.guest->difference);
  }
  comparison.pictures.push_back(compared("twin", "pieces with fractions of a point", reference.lines(),
                                         twin_pieces(run.twin, vectors, reference)));
  return std::nullopt;
}

}  // namespace

bool SceneComparison::agrees() const {
  return std::none_of(pictures.begin(), pictures.end(),
                      [](const ComparedPicture& p) { return p.identical && !*p.identical; }) &&
         std::all_of(faces.begin(), faces.end(), [](const ComparedFaces& f) { return f.agrees(); }) &&
         (!guest || guest->difference.empty()) && stripes_difference.empty() && (!turn || turn->agrees());
}

base::Result<SceneComparison> compare_cell_scene(const scene::CellScene& scene, const CompareOptions& options,
                                                 const CompareProgress& progress) {
  const scene::PolyScene polyhedra = scene::poly_scene_of(scene);
  SceneComparison comparison;
  comparison.scene = scene.name;
  comparison.camera = polyhedra.camera;
  comparison.camera.eye = options.eye.value_or(scene.default_view);
  comparison.eye = scene::file_point(polyhedra, comparison.camera.eye);
  if (auto error = compare_programs(scene, options, progress, comparison)) return *error;
  ScreenFrame frame;
  frame.scale = options.scale;
  frame.near = guests::jones::near_z;
  if (auto error = compare_algorithms(polyhedra, progress, frame, comparison)) return *error;
  compare_faces(polyhedra, progress, comparison);
  return comparison;
}

base::Result<SceneComparison> compare_poly_scene(const scene::PolyScene& scene,
                                                 const scene::PolyCamera& camera,
                                                 const CompareProgress& progress) {
  SceneComparison comparison;
  comparison.scene = scene.name;
  comparison.camera = camera;
  comparison.eye = scene::file_point(scene, camera.eye);
  if (auto error = compare_algorithms(scene, progress, std::nullopt, comparison)) return *error;
  compare_faces(scene, progress, comparison);
  if (const auto angle = turn_angle_of(camera)) {
    progress("turn");
    auto checked = check_turn(scene, *angle);
    if (checked)
      comparison.turn = std::move(*checked);
    else
      comparison.not_applicable.emplace_back("turn", checked.error().message());
  }
  return comparison;
}

}  // namespace sightline::compare
