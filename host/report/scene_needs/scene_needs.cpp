#include "host/report/scene_needs/scene_needs.hpp"

#include <fmt/format.h>

#include <utility>

#include "emulators/core/time.hpp"
#include "host/report/guest_runs.hpp"
#include "host/report/make_report.hpp"
#include "host/report/scene_needs/unseen_building.hpp"

namespace sightline::harness::report {

namespace {

std::int64_t count(auto value) {
  return static_cast<std::int64_t>(value);
}

constexpr double cycle_s = 1.75e-6;

Table core_table(const std::vector<std::pair<JonesOrder, JonesRun>>& runs) {
  Table table;
  table.id = "jones-core";
  table.title = "Jones: core and equipment, against what there was";
  table.columns = {{"scene", "Scene", "", false},
                   {"devices", "Equipment", "", false},
                   {"program_words", "Program", "words", false},
                   {"scene_words", "Scene", "words", false},
                   {"used_words", "In all", "words", false},
                   {"core_words", "There were", "words", false},
                   {"used_percent", "Used", "%", false},
                   {"stack_words", "Stack", "words", false},
                   {"stack_room_words", "There were", "words", false},
                   {"file_words", "Display file", "words", false},
                   {"file_room_words", "There were", "words", false}};
  for (const auto& [order, run] : runs) {
    const guests::jones::Program& program = run.program;
    table.rows.push_back(
        {order.scene, fmt::format("PDP-7, {}clock, switches, Type 340", order.eae ? "EAE, " : ""),
         count(program.program_words), count(program.scene.words.size()), count(program.words_used),
         count(guests::jones::core_words), Real{100.0 * program.words_used / guests::jones::core_words, 1},
         count(run.twin.stack_words), count(guests::jones::mask_stack_words),
         count(run.view().display_file.size()), count(program.labels.file_words)});
  }
  table.notes = {
      "In all: instructions, variables and constants, the scene, records of its openings, the mask stack and "
      "two display files, whose room is there whether a scene needs it or not. The stack is the deepest of "
      "this view. Present but not touched while a view is computed: the tape reader the program was loaded "
      "from."};
  return table;
}

Table work_table(const std::vector<std::pair<JonesOrder, JonesRun>>& runs) {
  Table table;
  table.id = "jones-work";
  table.title = "Jones: what a view looks at";
  table.columns = {{"scene", "Scene", "", false},
                   {"eae", "EAE", "", false},
                   {"cells", "Cells", "in the scene", false},
                   {"cells_read", "Cells", "read", false},
                   {"visits", "Visits", "", false},
                   {"depth", "Depth", "cells", false},
                   {"openings", "Openings", "in the scene", false},
                   {"openings_tested", "Openings", "tested", false},
                   {"masks", "Masks", "made", false},
                   {"view_s", "View", "s", false},
                   {"stolen_cycles", "Cycles stolen", "by the display", false},
                   {"stolen_percent", "Stolen", "% of the view", false}};
  for (const auto& [order, run] : runs) {
    const guests::jones::GuestView& view = run.view();
    const double time = seconds(view.time);
    table.rows.push_back({order.scene, std::string(order.eae ? "yes" : "no"), count(run.scene.cells.size()),
                          count(view.distinct_cells), count(view.visits), count(run.twin.depth),
                          count(run.scene.openings.size()), count(view.openings_tested),
                          count(run.twin.masks_made), Real{time, 3}, count(view.stolen_cycles),
                          Real{100 * cycle_s * static_cast<double>(view.stolen_cycles) / time, 2}});
  }
  table.notes = {
      "Cells read: cells any word of which the processor fetched, watched from outside. A cell that cannot "
      "be seen is never read. A cell seen through several openings is visited once for each. Every display "
      "word of the picture being shown costs the processor one cycle of 1.75 us."};
  return table;
}

}  // namespace

Outcome<Section> scene_needs(const Context& context) {
  Section section{"needs", "What the scene needed", {}};
  section.blocks.emplace_back(Paragraph{
      "What each scene asked of its machine, and what the machine had. A device that a program does not "
      "use is not there, and costs nothing."});
  auto jones_runs = run_all_jones(context, false);
  if (!jones_runs) return std::move(jones_runs.error());
  const auto& jones = *jones_runs;
  auto skala = make_chapter("skala-needs", context);
  if (!skala) return std::move(skala.error());
  auto unseen = unseen_building(context);
  if (!unseen) return std::move(unseen.error());
  section.blocks.emplace_back(core_table(jones));
  section.blocks.emplace_back(work_table(jones));
  for (Block& block : *unseen) section.blocks.push_back(std::move(block));
  for (Block& block : *skala) section.blocks.push_back(std::move(block));
  return section;
}

}  // namespace sightline::harness::report
