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
#include "host/compare/hard_cases/case_images.hpp"
#include "host/report/page.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::report {

namespace {

using compare::CrossCheckCell;
using compare::CrossCheckState;
using compare::NotApplicable;

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
    pictures.push_back({fmt::format("{}-{}", base::lower_case(scene.name), ++number), std::string(scene.name), std::string(scene.title),
                        fmt::format("{}{}", who, what), png_picture(image)});
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
    cells.push_back({std::string(scene.name), pair, verdict_of(cell)});
    run += cell.state == CrossCheckState::agrees || cell.state == CrossCheckState::differs ? 1U : 0U;
    if (cell.state == CrossCheckState::differs || cell.state == CrossCheckState::not_run)
      failures.push_back({std::string(scene.name), pair, cell.text});
  }
  const auto perspective = static_cast<std::size_t>(
      std::count_if(scene.views.begin(), scene.views.end(),
                    [](const compare::CrossCheckView& view) { return view.camera.perspective; }));
  const std::size_t listed = compare::listed_cells(scene);
  scenes.push_back({.scene = std::string(scene.name),
                    .what = std::string(scene.title),
                    .edges = picture::edges_of(scene.scene).size(),
                    .faces = scene::face_count(scene.scene),
                    .parallel = scene.views.size() - perspective,
                    .perspective = perspective,
                    .listed = listed,
                    .run = run,
                    .good = agreement.agrees() && run == listed});
  add_pictures(pictures, scene, agreement);
}

CrossCheck cross_check(const Context& context) {
  CrossCheck checked;
  for (const std::string_view name : compare::common_scene_names()) {
    const compare::CommonScene scene = compare::common_scene(name);
    checked.add(scene, compare::cross_check(scene, {}, context.progress));
  }
  return checked;
}

void cross_check_chapter(Page& page, const CrossCheck& checked) {
  page.table("agreement-matrix", "Every pair on every scene", checked.cells, {{"pair", "Pair", &PairVerdict::pair}},
             {.notes = {"pieces: the same pieces of the same edges between the same fractions. image: the same set of points, drawn of other edges "
                        "where edges lie on each other in the image. pixels: the same face at every pixel whose middle is more than 0.75 pixels "
                        "from all edges, hidden ones too. lines on pixels: wherever the face changes from a pixel to its neighbour a line is "
                        "drawn, and wherever a line is drawn with no other one within two pixels the face changes, both within one pixel (and "
                        "what rounding can do on a machine's display). points: turn-pdp7 is the program that turns solids on the PDP-7, at the "
                        "nearest of its 2^18 angles; the others draw for it at that angle, the visible pieces are the same, and no line is "
                        "farther from the other picture's than the lengths of the machine's words explain. n/a: does not apply, for a reason "
                        "listed below.",
                        "exact and oracle take part like the methods they check. Lines and faces of the oracle are found by different code.",
                        page.claim(checked.agrees(), fmt::format("All {} cells that are listed to run were run and agree.", shown(checked.run())),
                                   fmt::format("{} do not agree or were not run", checked.failures.size()))}},
             Pivot<PairVerdict>{.key = [](const PairVerdict& cell) { return base::lower_case(cell.scene); },
                                .title = &PairVerdict::scene,
                                .unit = {},
                                .cell = &PairVerdict::verdict});
  if (!checked.failures.empty())
    page.table("agreement-failures", "What does not agree, or could not be run", checked.failures,
               {{"scene", "Scene", &PairFailure::scene}, {"pair", "Pair", &PairFailure::pair}, {"first", "First difference", &PairFailure::first}});
  page.table("agreement-not-applicable", "What does not apply, and why", compare::not_applicable(),
             {{"method", "Method", &NotApplicable::who},
              {"scenes", "Scenes", "whose name begins so", &NotApplicable::scenes},
              {"views", "Views", [](const NotApplicable& n) { return n.views == NotApplicable::Views::all ? "all" : "in perspective"; }},
              {"reason", "Reason", &NotApplicable::reason}},
             {.folded = true});
  page.table("agreement-scenes", "The common scenes", checked.scenes,
             {{"scene", "Scene", &CheckedScene::scene},
              {"what", "What it is", &CheckedScene::what},
              {"edges", "Edges", &CheckedScene::edges},
              {"faces", "Faces", &CheckedScene::faces},
              {"parallel", "Views", "parallel", &CheckedScene::parallel},
              {"perspective", "Views", "perspective", &CheckedScene::perspective},
              {"listed", "Cells", "listed to run", &CheckedScene::listed},
              {"run", "Cells", "run", &CheckedScene::run},
              {"result", "Result", [](const CheckedScene& s) { return Verdict{s.good, s.good ? "all agree" : "not all agree"}; }}},
             {.notes = {"Parallel views look along level directions with whole cosines, so that a turn about y has them. Scenes parallel to the axes "
                        "are tilted by 38 times a rotation, but the corridor and the town, which stay degenerate on purpose. Of the town Willis "
                        "takes the walls in plan. H1 and H2 are two triangles a cell, in whole numbers that Skala's projection has, too. A cell "
                        "is a pair of methods on a scene; one that is listed to run and does not is a failure."}});
  page.gallery("agreement-pictures", "The first view of every scene by each method", checked.pictures,
               [](const MethodPicture& p) {
                 return figure(p.picture, "agreement-" + p.id, fmt::format("{}, {}.", p.scene, p.method), p.title,
                               fmt::format("The scene {} by {}", p.scene, p.method));
               },
               true);
}

}  // namespace sightline::report
