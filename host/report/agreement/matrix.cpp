// See agreement_matrix.hpp.
#include "host/report/agreement/matrix.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cstdint>
#include <string>
#include <utility>

#include "host/picture/line_picture.hpp"
#include "host/report/agreement/pictures.hpp"
#include "host/scene/model/face_numbers.hpp"

namespace sightline::harness::report {

namespace {

std::int64_t count(std::size_t value) {
  return static_cast<std::int64_t>(value);
}

std::string key_of(std::string_view scene) {
  std::string key;
  for (const char c : scene) key += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return key;
}

std::string pair_name(const compare::CrossCheckCell& cell) {
  return fmt::format("{} and {}", cell.first, cell.second);
}

Cell verdict_of(const compare::CrossCheckCell& cell) {
  switch (cell.state) {
    case compare::CrossCheckState::agrees: return Verdict{true, cell.how};
    case compare::CrossCheckState::differs: return Verdict{false, "differs"};
    case compare::CrossCheckState::not_run: return Verdict{false, "not run"};
    case compare::CrossCheckState::not_applicable: return std::string("n/a");
  }
  return {};
}

bool failed(const compare::CrossCheckCell& cell) {
  return cell.state == compare::CrossCheckState::differs || cell.state == compare::CrossCheckState::not_run;
}

Table scenes_table(std::span<const AgreedScene> scenes) {
  Table table;
  table.id = "agreement-scenes";
  table.title = "The common scenes";
  table.columns = {{"scene", "Scene", "", false},
                   {"what", "What it is", "", false},
                   {"edges", "Edges", "", false},
                   {"faces", "Faces", "", false},
                   {"parallel", "Views", "parallel", false},
                   {"perspective", "Views", "perspective", false},
                   {"listed", "Cells", "listed to run", false},
                   {"run", "Cells", "run", false},
                   {"result", "Result", "", false}};
  for (const auto& [scene, agreement] : scenes) {
    std::size_t perspective = 0;
    for (const compare::CrossCheckView& view : scene.views) perspective += view.camera.perspective ? 1 : 0;
    std::size_t run = 0;
    for (const compare::CrossCheckCell& cell : agreement.cells)
      run += cell.state == compare::CrossCheckState::agrees || cell.state == compare::CrossCheckState::differs
                 ? 1
                 : 0;
    const std::size_t listed = compare::listed_cells(scene);
    const bool good = agreement.agrees() && run == listed;
    table.rows.push_back({std::string(scene.name), std::string(scene.title),
                          count(picture::edges_of(scene.scene).size()), count(scene::face_count(scene.scene)),
                          count(scene.views.size() - perspective), count(perspective), count(listed),
                          count(run), Verdict{good, good ? "all agree" : "not all agree"}});
  }
  table.notes = {
      "Parallel views look along level directions with whole cosines, so that a turn about y has them. "
      "Scenes parallel to the axes are tilted by 38 times a rotation, but the corridor and the town, which "
      "stay degenerate on purpose. Of the town Willis takes the walls in plan. H1 and H2 are two triangles a "
      "cell, in whole numbers that Skala's projection has, too. A cell is a pair of methods on a scene; one "
      "that is listed to run and does not is a failure."};
  return table;
}

Table reasons_table() {
  Table table;
  table.id = "agreement-not-applicable";
  table.title = "What does not apply, and why";
  table.columns = {{"method", "Method", "", false},
                   {"scenes", "Scenes", "whose name begins so", false},
                   {"views", "Views", "", false},
                   {"reason", "Reason", "", false}};
  for (const compare::NotApplicable& listed : compare::not_applicable()) {
    const bool all = listed.views == compare::NotApplicable::Views::all;
    table.rows.push_back({std::string(listed.who), std::string(listed.scenes),
                          std::string(all ? "all" : "in perspective"), std::string(listed.reason)});
  }
  return table;
}

}  // namespace

Table agreement_matrix(std::span<const AgreedScene> scenes) {
  Table table;
  table.id = "agreement-matrix";
  table.title = "Every pair on every scene";
  table.columns = {{"pair", "Pair", "", false}};
  for (const AgreedScene& agreed : scenes)
    table.columns.push_back({key_of(agreed.scene.name), std::string(agreed.scene.name), "", false});
  if (scenes.empty()) return table;
  for (std::size_t pair = 0; pair < scenes.front().agreement.cells.size(); ++pair) {
    std::vector<Cell> row{pair_name(scenes.front().agreement.cells[pair])};
    for (const AgreedScene& agreed : scenes) row.push_back(verdict_of(agreed.agreement.cells[pair]));
    table.rows.push_back(std::move(row));
  }
  table.notes = {
      "pieces: the same pieces of the same edges between the same fractions. image: the same set of points, "
      "drawn of other edges where edges lie on each other in the image. pixels: the same face at every pixel "
      "whose middle is more than 0.75 pixels from all edges, hidden ones too. lines on pixels: wherever the "
      "face changes from a pixel to its neighbour a line is drawn, and wherever a line is drawn with no "
      "other one within two pixels the face changes, both within one pixel. n/a: does not apply, for a "
      "reason listed below.",
      "exact and oracle take part like the methods they check. Lines and faces of the oracle are found by "
      "different code."};
  return table;
}

Table agreement_failures(std::span<const AgreedScene> scenes) {
  Table table;
  table.id = "agreement-failures";
  table.title = "What does not agree, or could not be run";
  table.columns = {
      {"scene", "Scene", "", false}, {"pair", "Pair", "", false}, {"first", "First difference", "", false}};
  for (const AgreedScene& agreed : scenes)
    for (const compare::CrossCheckCell& cell : agreed.agreement.cells)
      if (failed(cell)) table.rows.push_back({std::string(agreed.scene.name), pair_name(cell), cell.text});
  return table;
}

Outcome<Section> all_against_each_other(const Context& context) {
  std::vector<AgreedScene> scenes;
  for (const std::string_view name : compare::common_scene_names()) {
    scenes.push_back({compare::common_scene(name), {}});
    scenes.back().agreement = compare::cross_check(scenes.back().scene, {}, context.progress);
  }
  Section section{"agreement", "All five against each other", {}};
  section.blocks.emplace_back(
      Paragraph{"Five methods that have nothing in common but the question, and two native answers to check "
                "them by, on scenes that most of them can be given. Where a method is exact it must agree "
                "exactly."});
  section.blocks.emplace_back(agreement_matrix(scenes));
  if (Table failures = agreement_failures(scenes); !failures.rows.empty())
    section.blocks.emplace_back(std::move(failures));
  section.blocks.emplace_back(reasons_table());
  section.blocks.emplace_back(scenes_table(scenes));
  section.blocks.emplace_back(Heading{"The first view of every scene, by each method"});
  for (const auto& [scene, agreement] : scenes) {
    context.progress(fmt::format("pictures of {}", scene.name));
    auto strip = agreement_strip(scene, agreement);
    if (!strip) return std::move(strip.error());
    section.blocks.emplace_back(std::move(*strip));
  }
  return section;
}

}  // namespace sightline::harness::report
