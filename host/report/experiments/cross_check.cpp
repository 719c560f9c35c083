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

// In perspective degrees, otherwise scene units.
double extent_of(const compare::CrossCheckView& view) {
  const auto window = view.window();
  const double half = window.width / 2.0 / window.scale;
  return view.camera.perspective ? 360 / std::numbers::pi * std::atan(half) : 2 * half;
}

// Whether the pair is one by which Jones's and Skala's programs are measured; their other pairs give no more
// information.
bool is_measured(const CrossCheckCell& cell) {
  return cell.first == "exact" || cell.second == compare::skala_8080_name;
}

void add_machines(std::vector<MachineFarthest>& machines, const compare::CommonScene& scene, const CrossCheckCell& cell) {
  if (!is_measured(cell)) return;
  for (const compare::CheckedDistance& distance : cell.distances) {
    const auto known = std::find_if(machines.begin(), machines.end(), [&](const MachineFarthest& m) {
      return m.scene == scene.name && m.machine == cell.second && m.other == cell.first && m.what == distance.what;
    });
    const MachineFarthest found{std::string(scene.name), std::string(scene.title), std::string(cell.second), std::string(cell.first), distance.what,
                                distance.found, distance.bound};
    if (known == machines.end())
      machines.push_back(found);
    else if (found.part() > known->part())
      *known = found;
  }
}

template <class Rows>
void machine_table(Page& page, const std::string& id, const std::string& title, const Rows& rows, const std::string& note) {
  page.table(id, title, rows,
             {{"machine", "Machine", &MachineFarthest::machine}, {"other", "Measured from", &MachineFarthest::other}, {"what", "What", &MachineFarthest::what}},
             {.notes = {note}},
             Pivot<MachineFarthest>{.key = [](const MachineFarthest& m) { return base::lower_case(m.scene); },
                                    .title = [](const MachineFarthest& m) { return m.scene + ", " + m.title; },
                                    .unit = "points",
                                    .cell = [](const MachineFarthest& m) { return Verdict{m.found <= m.bound, fmt::format("{:.{}f} of {:.{}f}", m.found, m.places(), m.bound, m.places())}; }});
}

void add_pictures(std::vector<MethodPicture>& pictures, const compare::CommonScene& scene, const compare::SceneCrossCheck& agreement) {
  int number = 0;
  const compare::CrossCheckView& view = scene.views.front();
  const auto add = [&](std::string_view who, std::string_view what, const picture::Image& image) {
    pictures.push_back({fmt::format("{}-{}", base::lower_case(scene.name), ++number), std::string(scene.name),
                        std::string(scene.title), fmt::format("{}{}", who, what), png_picture(image)});
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
    if (picture.builds) {
      std::vector<picture::DrawnPiece> lines;
      for (const picture::PixelSegment& line : picture.builds->back().lines) lines.push_back({0, line});
      add(name, fmt::format(", f={}", picture.builds->back().words.fraction_bits), compare::screen_image(lines));
    }
    if (picture.ink)
      for (const compare::SkalaInk& ink : *picture.ink)
        if (ink.device == programs::skala::Device::ef9365 || (ink.device == programs::skala::Device::calcomp && compare::shows_lines(ink)))
          add(name, ", " + compare::name_of(ink), compare::faces_image(ink.dots, compare::case_image_side));
    if (picture.faces) add(name, picture.lines ? " (faces)" : "", compare::faces_image(*picture.faces, compare::case_image_side));
  }
  if (number == 0) throw base::difference(fmt::format("{}: no method has a picture", scene.name));
}

}  // namespace

bool CrossCheck::agrees() const {
  return failures.empty() &&
         std::all_of(scenes.begin(), scenes.end(), [](const CheckedScene& scene) { return scene.run == scene.listed; });
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
    add_machines(machines, scene, cell);
    run += cell.state == CrossCheckState::agrees || cell.state == CrossCheckState::differs ? 1U : 0U;
    if (cell.state == CrossCheckState::differs || cell.state == CrossCheckState::not_run)
      failures.push_back({std::string(scene.name), pair, cell.text});
  }
  const auto perspective = static_cast<std::size_t>(std::count_if(
      scene.views.begin(), scene.views.end(), [](const compare::CrossCheckView& view) { return view.camera.perspective; }));
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
             {.notes = {"pieces: the same pieces of the same edges between the same fractions. image: the same set of points, "
                        "possibly from other edges where edges coincide in the image. pixels: the same face at every pixel "
                        "whose centre is more than 0.75 pixels from all edges, visible or hidden. lines on pixels: there is a "
                        "line wherever the face changes between adjacent pixels, and the face changes at every line that has "
                        "no other line within two pixels, both within one pixel (plus the rounding of a machine's display). "
                        "points: turn-pdp7 is the program that turns solids on the PDP-7, at the nearest of its 2^18 angles; "
                        "the others draw at that angle, the visible pieces are the same, and no line is farther from the other "
                        "picture than the lengths of the machine's words explain. The next tables give the distances for "
                        "jones-pdp7 and skala-8080. words: the same display words, with every number of fraction bits. n/a: "
                        "not applicable, for a reason listed below.",
                        "exact and oracle take part like the methods they check. Different code computes the oracle's lines "
                        "and its faces.",
                        page.claim(checked.agrees(), fmt::format("All {} cells that are listed to run were run and agree.", text_of(checked.run())),
                                   fmt::format("{} differ or were not run", checked.failures.size()))}},
             Pivot<PairVerdict>{.key = [](const PairVerdict& cell) { return base::lower_case(cell.scene); },
                                .title = &PairVerdict::scene,
                                .unit = {},
                                .cell = &PairVerdict::verdict});
  if (!checked.failures.empty())
    page.table("agreement-failures", "Pairs that differ or could not be run", checked.failures,
               {{"scene", "Scene", &PairFailure::scene}, {"pair", "Pair", &PairFailure::pair}, {"first", "First difference", &PairFailure::first}});
  const auto of_jones = where(checked.machines, [](const MachineFarthest& m) { return m.machine != compare::skala_8080_name; });
  const auto of_skala = where(checked.machines, [](const MachineFarthest& m) { return m.machine == compare::skala_8080_name; });
  machine_table(page, "agreement-jones", "Jones's program: its lines and the exact ones", of_jones,
                "The view of each scene that comes nearest to its bound. The first number is the greatest distance, in points "
                "of the Type 340, between the program's lines and the exact ones, the second is the bound that follows from "
                "its words. f is the number of fraction bits; lit: the points of one pass of the display, whose vector "
                "generator deviates from the line. jones-pdp7 is the program on its machine, with and without the EAE; "
                "jones-twin is the same program in C++ with words of 24 bits, before its pieces are rounded to points. The "
                "bounds are computed for each view from the roundings of each end point. They hold for these views, not for "
                "all: where two portals meet in a side that is no line, their masks are rounded independently, and a line in "
                "the gap between them, at a small angle to it, can be lost over any length.");
  machine_table(page, "agreement-skala", "Skala's program: its ink and the unrounded lines", of_skala,
                "The first number is the greatest distance, in dots, between ink and the lines between the samples (oracle: "
                "their visible parts, not rounded; skala: those that the native algorithm draws). The second is the bound that "
                "follows from integer coordinates, the dots of a line and the test by columns. Contours hide nothing and are "
                "tested with a tolerance of one dot, so only their positions are measured. On the boards every dot of every "
                "picture equals the column oracle's. A plotter draws a surface as lines.");
  page.table("agreement-not-applicable", "Pairs that are not applicable, with reasons", compare::not_applicable(),
             {{"method", "Method", &NotApplicable::who},
              {"scenes", "Scenes", "whose names begin with", &NotApplicable::scenes},
              {"views", "Views", [](const NotApplicable& n) { return n.views == NotApplicable::Views::all ? "all" : "in perspective"; }},
              {"reason", "Reason", &NotApplicable::reason}},
             {.notes = {fmt::format("skala-8080 with methods other than oracle and skala: {}.", *compare::why_incomparable(compare::skala_8080_name, "exact"))},
              .folded = true});
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
             {.notes = {"Parallel views look along level directions with rational cosines, which are also views of a turn "
                        "about y. Axis-parallel scenes are tilted by 38 times a rotation, except the corridor and the town, "
                        "which stay degenerate on purpose. For Willis, the town is walls in plan. H1 and H2 have two triangles "
                        "per cell, in integers that Skala's projection has, too. J1 to J4 are scenes of cells without a tilt: "
                        "solids and walls hide, the real lines are drawn, including those of the outer box; Jones uses their "
                        "own cells. The second view of each is one where the program's lines are far from the exact ones with "
                        "any number of fraction bits. A cell is a pair of methods on a scene. A listed cell that is not run is "
                        "a failure."}});
  page.gallery("agreement-pictures", "The first view of every scene by each method", checked.pictures,
               [](const MethodPicture& p) {
                 return figure(p.picture, "agreement-" + p.id, fmt::format("{}, {}.", p.scene, p.method), p.title,
                               fmt::format("The scene {} by {}", p.scene, p.method));
               },
               true);
}

}  // namespace sightline::report
