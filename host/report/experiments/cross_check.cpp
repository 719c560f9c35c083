// All algorithms compared with each other on the common scenes.
//
//   cells     a pair of methods on a scene: how they agree, or that they do not
//   failures  the cells that differ or could not be run, with the first difference
//   scenes    a scene each: size, views, cells listed to run and run
//   reasons   what does not apply, as listed
//   pictures  the first view of each scene by every method
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
#include "host/report/experiments/experiments.hpp"
#include "host/report/experiments/png_picture.hpp"
#include "host/compare/hard_cases/case_images.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::report {

namespace {

using compare::CrossCheckCell;
using compare::CrossCheckState;

Value verdict_of(const CrossCheckCell& cell) {
  switch (cell.state) {
    case CrossCheckState::agrees: return Verdict{true, cell.how};
    case CrossCheckState::differs: return Verdict{false, "differs"};
    case CrossCheckState::not_run: return Verdict{false, "not run"};
    case CrossCheckState::not_applicable: return "n/a";
  }
  return {};
}

// Degrees in perspective, else scene units.
double extent_of(const compare::CrossCheckView& view) {
  const auto window = view.window();
  const double half = window.width / 2.0 / window.scale;
  return view.camera.perspective ? 360 / std::numbers::pi * std::atan(half) : 2 * half;
}

void add_pictures(RowSet& pictures, const compare::CommonScene& scene, const compare::SceneCrossCheck& agreement) {
  int number = 0;
  const compare::CrossCheckView& view = scene.views.front();
  const auto add = [&](std::string_view who, std::string_view what, const picture::Image& image) {
    pictures.add({{"id", fmt::format("{}-{}", base::lower_case(scene.name), ++number)},
                  {"scene", scene.name},
                  {"title", scene.title},
                  {"method", fmt::format("{}{}", who, what)},
                  {"picture", png_picture(image)}});
  };
  for (std::size_t who = 0; who < compare::participants().size(); ++who) {
    const compare::CrossCheckPicture& picture = agreement.pictures[who].front();
    const std::string_view name = compare::participants()[who].name;
    if (picture.lines) add(name, "", compare::lines_image(*picture.lines, scene.scene, view.camera, extent_of(view)));
    if (picture.screen) {
      std::vector<picture::DrawnPiece> lines;
      for (const picture::PixelSegment& line : picture.screen->turn.lines) lines.push_back({0, line});
      add(name, "", compare::screen_image(lines));
    }
    if (picture.faces) add(name, picture.lines ? " (faces)" : "", compare::faces_image(*picture.faces, compare::case_image_side));
  }
  if (number == 0) throw Failure(ErrorKind::differs, fmt::format("{}: no method has a picture", scene.name));
}

}  // namespace

void add_cross_check(Records& records, const compare::CommonScene& scene,
                     const compare::SceneCrossCheck& agreement) {
  RowSet& failures = records["failures"];
  if (failures.keys().empty()) failures = RowSet({"scene", "pair", "first"});
  std::size_t run = 0;
  for (const CrossCheckCell& cell : agreement.cells) {
    const std::string pair = fmt::format("{} and {}", cell.first, cell.second);
    records["cells"].add({{"scene", scene.name},
                          {"column", base::lower_case(scene.name)},
                          {"pair", pair},
                          {"verdict", verdict_of(cell)}});
    run += cell.state == CrossCheckState::agrees || cell.state == CrossCheckState::differs ? 1U : 0U;
    if (cell.state == CrossCheckState::differs || cell.state == CrossCheckState::not_run)
      failures.add({{"scene", scene.name}, {"pair", pair}, {"first", cell.text}});
  }
  const auto perspective =
      std::count_if(scene.views.begin(), scene.views.end(),
                    [](const compare::CrossCheckView& view) { return view.camera.perspective; });
  const std::size_t listed = compare::listed_cells(scene);
  const bool good = agreement.agrees() && run == listed;
  records["scenes"].add({{"scene", scene.name},
                         {"what", scene.title},
                         {"edges", picture::edges_of(scene.scene).size()},
                         {"faces", scene::face_count(scene.scene)},
                         {"parallel", static_cast<std::int64_t>(scene.views.size()) - perspective},
                         {"perspective", perspective},
                         {"listed", listed},
                         {"run", run},
                         {"result", Verdict{good, good ? "all agree" : "not all agree"}}});
  add_pictures(records["pictures"], scene, agreement);
}

Records cross_check(const Context& context) {
  Records records;
  for (const std::string_view name : compare::common_scene_names()) {
    const compare::CommonScene scene = compare::common_scene(name);
    add_cross_check(records, scene, compare::cross_check(scene, {}, context.progress));
  }
  for (const compare::NotApplicable& listed : compare::not_applicable()) {
    const bool all = listed.views == compare::NotApplicable::Views::all;
    records["reasons"].add({{"method", listed.who},
                            {"scenes", listed.scenes},
                            {"views", all ? "all" : "in perspective"},
                            {"reason", listed.reason}});
  }
  return records;
}

}  // namespace sightline::report
