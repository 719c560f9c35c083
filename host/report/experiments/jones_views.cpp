// Jones's program on the PDP-7: the five built-in scenes from their default views, with the EAE and without; a
// stereoscopic pair; a corridor that grows behind what is seen. What a view takes in time, and what of the core.
//
//   views      a scene, with the EAE or without, each. The second view is the one measured: the display shows the
//              first meanwhile and takes cycles. Pictures are there of runs with the EAE.
//   pair       roberts as a stereoscopic pair
//   machine    its memory cycle
//   elements   words of the elements of each scene, as assembled, and those of openings as Fig. 6 has them
//   corridors  corridor8 and corridor32: the same few rooms are seen
#include <fmt/core.h>

#include <string>
#include <utility>

#include "emulators/pdp7/timing.hpp"
#include "host/report/experiments/experiments.hpp"
#include "host/report/experiments/guest_runs.hpp"
#include "host/scene/read/builtin.hpp"

namespace sightline::report {

namespace {

namespace jones = guests::jones;

void add_view(RowSet& views, const JonesOrder& order, const JonesRun& run) {
  const jones::GuestView& view = run.view();
  const jones::Program& program = run.program;
  views.add({{"scene", order.scene},
             {"eae", order.eae},
             {"first_view_s", seconds(run.guest.views.front().time)},
             {"second_view_s", seconds(view.time)},
             {"instructions", view.instructions},
             {"lines_clipped", view.lines_clipped},
             {"pieces", view.pieces},
             {"refresh_s", seconds(run.guest.refresh_period)},
             {"stolen_cycles", view.stolen_cycles},
             {"cells", run.scene.cells.size()},
             {"cells_read", view.distinct_cells},
             {"visits", view.visits},
             {"depth", run.twin.depth},
             {"openings", run.scene.openings.size()},
             {"openings_tested", view.openings_tested},
             {"masks", run.twin.masks_made},
             {"devices", fmt::format("PDP-7, {}clock, switches, Type 340", order.eae ? "EAE, " : "")},
             {"program_words", program.program_words},
             {"scene_words", program.scene.words.size()},
             {"used_words", program.words_used},
             {"core_words", jones::core_words},
             {"stack_words", run.twin.stack_words},
             {"stack_room_words", jones::mask_stack_words},
             {"file_words", view.display_file.size()},
             {"file_room_words", program.labels.file_words},
             {"screen", order.eae ? Value(crisp_png(run)) : Value()},
             {"phosphor", order.eae ? Value(phosphor_png(run)) : Value()}});
}

// Fig. 6 gives six words an opening-element, and one for each vector.
void add_elements(RowSet& elements, const JonesOrder& order, const JonesRun& run) {
  constexpr std::size_t opening_head = 6;
  std::size_t of_openings = 0;
  for (const scene::Opening& opening : run.scene.openings) of_openings += opening_head + opening.vectors.size();
  elements.add({{"scene", order.scene},
                {"opening_words", run.program.scene.opening_words},
                {"opening_words_counted", of_openings},
                {"cell_words", run.program.scene.cell_words}});
}

}  // namespace

Records jones_views(const Context& context) {
  Records records;
  records["machine"].add({{"cycle_us", 1e6 * seconds(pdp7::machine_cycle)}});
  for (const std::string_view name : scene::builtin_scene_names()) {
    context.progress(fmt::format("{} on the PDP-7", name));
    for (const bool eae : {true, false}) {
      const JonesOrder order{std::string(name), eae, false, eae};
      const JonesRun made = run_jones(order);
      add_view(records["views"], order, made);
      if (eae) add_elements(records["elements"], order, made);
    }
  }
  records["pair"].add({{"view_s", seconds(run_jones({"roberts", true, true, false}).view().time)}});
  for (const bool eae : {true, false}) {
    for (const char* const name : {"corridor8", "corridor32"}) {
      const JonesRun made = run_jones({name, eae, false, false});
      // The first view, while the display takes no cycles.
      const jones::GuestView& view = made.guest.views.front();
      records["corridors"].add({{"scene", name},
                                {"eae", eae},
                                {"cells", made.scene.cells.size()},
                                {"cells_read", view.distinct_cells},
                                {"visits", view.visits},
                                {"instructions", view.instructions},
                                {"view_s", seconds(view.time)}});
    }
  }
  return records;
}

}  // namespace sightline::report
