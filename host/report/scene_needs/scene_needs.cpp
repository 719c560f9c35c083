#include "host/report/scene_needs/scene_needs.hpp"

#include <fmt/format.h>

#include <utility>

#include "emulators/core/time.hpp"
#include "host/guests/skala/commands.hpp"
#include "host/report/guest_runs.hpp"
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

Table memory_table(const guests::skala::Program& program) {
  constexpr std::int64_t page = 256;
  Table table;
  table.id = "skala-memory";
  table.title = "Skala: memory of the 8080";
  table.columns = {{"what", "What", "", false},
                   {"lines_bytes", "For lines", "bytes", false},
                   {"surface_bytes", "For surfaces", "bytes", false},
                   {"contours_bytes", "For contours", "bytes", false}};
  const auto row = [&table](const char* what, std::int64_t lines, std::int64_t surface,
                            std::int64_t contours) {
    table.rows.push_back({std::string(what), lines, surface, contours});
  };
  const auto image = count(program.memory.size());
  row("state and command table (page 0)", page, page, page);
  row("program", image - page, image - page, image - page);
  row("masks: top and bottom of what is hidden", 2 * page, 2 * page, 2 * page);
  row("the slice before: rows and levels", 0, 2 * page, 0);
  row("folds, for silhouettes", 0, 0, 2 * page);
  row("pages written but never read, and the stack", 3 * page, 3 * page, 3 * page);
  row("buffer of commands", guests::skala::buffer_bytes, guests::skala::buffer_bytes,
      guests::skala::buffer_bytes);
  row("there were", 65536, 65536, 65536);
  table.notes = {
      "One program draws all three kinds of picture. The paper does not say what its memory held."};
  return table;
}

Table dots_table(const std::vector<std::pair<SkalaOrder, SkalaRun>>& runs) {
  Table table;
  table.id = "skala-work";
  table.title = "Skala: what a picture takes";
  table.columns = {{"function", "Function", "", false},
                   {"picture", "Picture", "", false},
                   {"command_bytes", "Commands", "bytes", false},
                   {"blocks", "Blocks", "", false},
                   {"instructions", "Instructions", "", false},
                   {"drawing_t_states", "Drawing", "T-states", false},
                   {"walked", "Points walked", "", false},
                   {"dots", "Dots written", "", false},
                   {"dots_busy_t_states", "Board busy with them", "T-states", false},
                   {"dots_busy_percent", "Busy", "% of drawing", false}};
  for (const auto& [order, run] : runs) {
    const auto drawing = static_cast<double>(run.guest.drawing.count());
    table.rows.push_back({order.function, std::string(name_of(order.picture)), count(run.stream_bytes),
                          count(run.guest.blocks), count(run.guest.instructions),
                          count(run.guest.drawing.count()), count(run.twin.points_walked),
                          count(run.twin.points_plotted), count(run.dots_busy.count()),
                          Real{100 * static_cast<double>(run.dots_busy.count()) / drawing, 1}});
  }
  table.notes = {
      "The board is done with a dot long before the processor has the next: it never waits for one. Clearing "
      "the picture, two fields of the display or 120,000 T-states, is in the drawing time. Instructions "
      "include the receipt of the commands. The machine: 8080 at 3 MHz, 64 KB, EF9365 board, parallel link."};
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
  const guests::skala::Program program = guests::skala::assemble_program();
  const auto skala_runs = run_all_skala(context, program, false);
  if (!skala_runs) return skala_runs.error();
  auto unseen = unseen_building(context);
  if (!unseen) return std::move(unseen.error());
  section.blocks.emplace_back(core_table(jones));
  section.blocks.emplace_back(work_table(jones));
  for (Block& block : *unseen) section.blocks.push_back(std::move(block));
  section.blocks.emplace_back(memory_table(program));
  section.blocks.emplace_back(dots_table(*skala_runs));
  return section;
}

}  // namespace sightline::harness::report
