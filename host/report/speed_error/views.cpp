#include "host/report/speed_error/views.hpp"

#include <algorithm>
#include <utility>

#include "host/algorithms/oracle/matter.hpp"
#include "host/algorithms/oracle/visible_lines.hpp"
#include "host/scene/read/cell_scene.hpp"

namespace sightline::harness::report {

namespace {

namespace oracle = algorithms::oracle;

// Tried in each view: 24,000 a scene, of which more than 10,000 are farther than a pixel from where
// visibility changes.
constexpr std::uint64_t points_a_view = 4000;

ReportError unusable(std::string_view scene, const std::string& why) {
  return {ErrorKind::bad_input, std::string(scene) + ": " + why};
}

}  // namespace

Outcome<SceneViews> SceneViews::of(const guests::jones::SixViews& views) {
  auto scene = scene::load_cell_scene(std::string(views.scene));
  if (!scene) return ReportError{ErrorKind::bad_input, scene.error().message()};
  SceneViews result;
  result.name_ = views.scene;
  result.scene_ = std::move(*scene);
  const auto matter = oracle::Matter::of(result.scene_);
  if (!matter) return unusable(views.scene, "found a scene with too many grid units for the exact reference");
  const auto lines = matter->real_lines();
  oracle::Window window;
  window.near = guests::jones::near_z;
  for (const geometry::Point& eye : views.eyes) {
    auto in_core = guests::jones::scene_in_core(result.scene_, eye);
    if (!in_core) return unusable(views.scene, in_core.error().message());
    const auto visible = oracle::visible_lines(*matter, lines, eye, window);
    result.views_.push_back({eye, std::move(*in_core), compare::CellReference(lines, visible, eye, window)});
  }
  return result;
}

picture::DrawnPiece SceneViews::piece(std::size_t view, const guests::jones::SceneLine& line,
                                      const algorithms::oracle::ScreenSegment& image) const {
  const auto [u, v] = geometry::other_axes(line.axis);
  const compare::AxisLine of{line.axis, {line.from[u], line.from[v]}};
  return {views_[view].reference.number_of(of), {{image.x0, image.y0}, {image.x1, image.y1}}};
}

void SceneViews::add(PictureError& error, std::size_t view, guests::jones::Status status,
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
  error.incomplete += status == guests::jones::Status::complete ? 0 : 1;
}

}  // namespace sightline::harness::report
