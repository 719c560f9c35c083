#include "host/report/experiments/cross_check.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "host/base/text.hpp"
#include "host/picture/line_picture.hpp"
#include "host/report/experiments/png_picture.hpp"
#include "host/report/hard_cases/case_images.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::report {

namespace {

using compare::CrossCheckCell;
using compare::CrossCheckState;

Cell verdict_of(const CrossCheckCell& cell) {
  switch (cell.state) {
    case CrossCheckState::agrees: return Verdict{true, cell.how};
    case CrossCheckState::differs: return Verdict{false, "differs"};
    case CrossCheckState::not_run: return Verdict{false, "not run"};
    case CrossCheckState::not_applicable: return std::string("n/a");
  }
  return {};
}

// Degrees in perspective, else scene units.
double extent_of(const compare::CrossCheckView& view) {
  const auto window = view.window();
  const double half = window.width / 2.0 / window.scale;
  return view.camera.perspective ? 360 / std::numbers::pi * std::atan(half) : 2 * half;
}

void add_pictures(std::vector<MethodPicture>& pictures, const compare::CommonScene& scene, const compare::SceneCrossCheck& agreement) {
  int number = 0;
  const compare::CrossCheckView& view = scene.views.front();
  const auto add = [&](std::string_view who, std::string_view what, const picture::Image& image) {
    pictures.push_back({fmt::format("{}-{}", base::lower_case(scene.name), ++number), scene.name, scene.title,
                        fmt::format("{}{}", who, what), png_picture(image)});
  };
  for (std::size_t who = 0; who < compare::participants().size(); ++who) {
    const compare::CrossCheckPicture& picture = agreement.pictures[who].front();
    const std::string_view name = compare::participants()[who].name;
    if (picture.lines) add(name, "", lines_image(*picture.lines, scene.scene, view.camera, extent_of(view)));
    if (picture.screen) {
      std::vector<picture::DrawnPiece> lines;
      for (const picture::PixelSegment& line : picture.screen->turn.lines) lines.push_back({0, line});
      add(name, "", screen_image(lines));
    }
    if (picture.faces) add(name, picture.lines ? " (faces)" : "", faces_image(*picture.faces, case_image_side));
  }
  if (number == 0) throw Failure(ErrorKind::differs, fmt::format("{}: no method has a picture", scene.name));
}

}  // namespace

bool CrossCheck::agrees() const {
  return failures.empty() && std::all_of(scenes.begin(), scenes.end(), [](const CheckedScene& scene) { return scene.run == scene.listed; });
}

std::size_t CrossCheck::run() const {
  std::size_t all = 0;
  for (const CheckedScene& scene : scenes) all += scene.run;
  return all;
}

void CrossCheck::add(const compare::CommonScene& scene, const compare::SceneCrossCheck& agreement) {
  std::size_t run = 0;
  for (const CrossCheckCell& cell : agreement.cells) {
    const std::string pair = fmt::format("{} and {}", cell.first, cell.second);
    cells.push_back({scene.name, pair, verdict_of(cell)});
    run += cell.state == CrossCheckState::agrees || cell.state == CrossCheckState::differs ? 1U : 0U;
    if (cell.state == CrossCheckState::differs || cell.state == CrossCheckState::not_run)
      failures.push_back({scene.name, pair, cell.text});
  }
  const auto perspective = static_cast<std::size_t>(
      std::count_if(scene.views.begin(), scene.views.end(),
                    [](const compare::CrossCheckView& view) { return view.camera.perspective; }));
  const std::size_t listed = compare::listed_cells(scene);
  scenes.push_back({.scene = scene.name,
                    .what = scene.title,
                    .edges = picture::edges_of(scene.scene).size(),
                    .faces = scene::face_count(scene.scene),
                    .parallel = scene.views.size() - perspective,
                    .perspective = perspective,
                    .listed = listed,
                    .run = run,
                    .good = agreement.agrees() && run == listed});
  add_pictures(pictures, scene, agreement);
}

CrossCheck measure_cross_check(const Context& context) {
  CrossCheck checked;
  for (const std::string_view name : compare::common_scene_names()) {
    const compare::CommonScene scene = compare::common_scene(name);
    checked.add(scene, compare::cross_check(scene, {}, context.progress));
  }
  return checked;
}

}  // namespace sightline::report
