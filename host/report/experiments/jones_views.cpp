#include "host/report/experiments/jones_views.hpp"

#include <fmt/core.h>

#include <string>
#include <utility>

#include "emulators/pdp7/timing.hpp"
#include "host/report/experiments/guest_runs.hpp"
#include "host/scene/read/builtin.hpp"

namespace sightline::report {

namespace {

namespace jones = programs::jones;

JonesView view_of(const JonesOrder& order, const JonesRun& run) {
  const jones::View& view = run.view();
  const jones::Program& program = run.program.program();
  JonesView made;
  made.scene = order.scene;
  made.eae = order.eae;
  made.first_view_s = seconds(run.outcome.views.front().time);
  made.second_view_s = seconds(view.time);
  made.instructions = view.instructions;
  made.lines_clipped = view.lines_clipped;
  made.pieces = view.pieces;
  made.refresh_s = seconds(run.outcome.refresh_period);
  made.stolen_cycles = view.stolen_cycles;
  made.cells = run.scene.cells.size();
  made.cells_read = view.distinct_cells;
  made.visits = view.visits;
  made.depth = run.twin.depth;
  made.openings = run.scene.openings.size();
  made.openings_tested = view.openings_tested;
  made.masks = run.twin.masks_made;
  made.devices = fmt::format("PDP-7, {}clock, switches, Type 340", order.eae ? "EAE, " : "");
  made.program_words = program.program_words;
  made.scene_words = program.scene.words.size();
  made.used_words = program.words_used;
  made.stack_words = run.twin.stack_words;
  made.file_words = view.display_file.size();
  made.file_room_words = program.labels.file_words;
  if (order.eae) {
    made.screen = crisp_png(run);
    made.phosphor = phosphor_png(run);
  }
  return made;
}

// Fig. 6 has six words per opening element, and one for each vector.
JonesElements elements_of(const JonesOrder& order, const JonesRun& run) {
  constexpr std::size_t opening_head = 6;
  std::size_t of_openings = 0;
  for (const scene::Opening& opening : run.scene.openings) of_openings += opening_head + opening.vectors.size();
  return {order.scene, run.program.program().scene.opening_words, of_openings, run.program.program().scene.cell_words};
}

// The times of a scene with and without the EAE.
std::string both_times(const JonesViews& jones, const JonesView& view) {
  return fmt::format("{} s, without EAE {} s", text_of(view.second_view_s, 3),
                     text_of(jones.view(view.scene, false).second_view_s, 3));
}

std::string equal_or_not(bool equal) {
  return equal ? "equal" : "not equal";
}

void paper_times(Page& page, const JonesViews& jones) {
  const auto& views = jones.views;
  const Figures all = least_and_greatest(views, &JonesView::second_view_s);
  const Figures roberts{as_cell(jones.view("roberts", true).second_view_s), as_cell(jones.view("roberts", false).second_view_s)};
  const auto time = range_of(views, &JonesView::second_view_s);
  const double frame = 1 / page.paper_figure("jones.frames").greatest;
  const std::string second_views = "second default view of each of five scenes, with and without EAE";
  page.claims(
      "jones-paper-times", "Jones 1971: every number for time",
      {{"jones.few_seconds", all, 3, second_views,
        fmt::format("{} of {} take a second or more. The paper does not say whether its machine had the EAE",
                    count(views, [](const JonesView& view) { return view.second_view_s >= 1; }), views.size())},
       {"jones.order_of_seconds", all, 3, second_views, "as above"},
       {"jones.photographs", {}, Real::as_needed, "",
        "cannot be compared: needs the times legible in Figs. 8-10 and 13, in a better copy of the journal, and the "
        "coordinates of the objects, which the paper does not give"},
       {"jones.roberts_object", roberts, 3, "roberts, with and without EAE",
        "cannot be compared to the digit: needs the times legible in Figs. 11 and 12, in a better copy of the journal, and "
        "the coordinates of Roberts's object (Roberts 1963); roberts is made after the description"},
       {"jones.roberts_program", roberts, 3, "roberts, with and without EAE",
        "cannot be compared: another program on another machine, from hearsay (\"believed\"); needs a time that Roberts "
        "himself gives"},
       {"jones.frames", {as_cell(1 / time.greatest), as_cell(1 / time.least)}, 1, second_views,
        fmt::format("{} of {} views are computed that fast",
                    count(views, [frame](const JonesView& view) { return view.second_view_s <= frame; }), views.size())},
       {"jones.pair", {{}, as_cell(jones.pair_s)}, 3, "roberts as a pair, with EAE",
        fmt::format("cannot be compared: needs a time for Fig. 14, which the paper does not give. Here a pair takes {} times "
                    "one view",
                    text_of(jones.pair_s / jones.view("roberts", true).second_view_s, 2))}});
}

void paper_sizes(Page& page, const JonesViews& jones) {
  const auto used = range_of(jones.views, &JonesView::used_words);
  const JonesElements& street4 = only(jones.elements, equals(&JonesElements::scene, "street4"));
  const std::size_t house_cells = jones.view("house", true).cells;
  const auto paper = [&page](std::string_view claim) { return page.paper_figure(claim).greatest; };
  page.claims(
      "jones-paper-sizes", "Jones 1971: every number for size",
      {{"jones.core",
        {as_cell(used.least), as_cell(used.greatest)},
        Real::as_needed,
        "program, scene, stack and two display files of all runs",
        page.claim(static_cast<double>(used.greatest) <= paper("jones.core"), "all fit", fmt::format("{} words", used.greatest))},
       {"jones.cycle", one_figure(jones_cycle_us()), 2, "the emulated PDP-7",
        equal_or_not(jones_cycle_us() == paper("jones.cycle"))},
       {"jones.display",
        {as_cell(1000 * jones.view("house", true).refresh_s), as_cell(1000 * jones.view("street4", true).refresh_s)},
        2,
        "one refresh of house and of street4",
        "cannot be compared: needs a refresh time or the length of a display file, neither of which is given"},
       {"jones.house", one_figure(house_cells), Real::as_needed, "house",
        equal_or_not(static_cast<double>(house_cells) == paper("jones.house")) +
            "; comparing times needs the measures of the rooms, which are not given"},
       {"jones.opening_element",
        {as_cell(street4.opening_words_counted), as_cell(street4.opening_words)},
        Real::as_needed,
        "street4: counted by the figure, and as assembled",
        fmt::format("{}: two words of cells, three of the origin, one of the count",
                    street4.opening_words == street4.opening_words_counted ? "the same layout" : "another layout")},
       {"jones.cell_element", one_figure(street4.cell_words), Real::as_needed, "street4, as assembled",
        "cannot be compared: needs the words of a scene; the paper gives none"},
       {"jones.switches", {}, Real::as_needed, "", "the program reads AC switches 0 to 7"},
       {"jones.lists",
        {},
        Real::as_needed,
        "",
        "cannot be compared: needs the symbolic tapes of the objects, or their diagrams (one is in Fig. 7)"}});
}

}  // namespace

double jones_cycle_us() {
  return 1e6 * seconds(pdp7::machine_cycle);
}

const JonesView& JonesViews::view(std::string_view scene, bool eae) const {
  return only(views, [=](const JonesView& view) { return view.scene == scene && view.eae == eae; });
}

bool JonesViews::unseen_rooms_cost_nothing() const {
  const auto same = [this](bool eae) {
    const auto rows = where(corridors, equals(&JonesCorridor::eae, eae));
    return distinct(rows, &JonesCorridor::instructions) == 1 && distinct(rows, &JonesCorridor::view_s) == 1;
  };
  return same(true) && same(false);
}

JonesViews jones_views(const Context& context) {
  JonesViews made;
  for (const std::string_view name : scene::builtin_scene_names()) {
    context.progress(fmt::format("{} on the PDP-7", name));
    for (const bool eae : {true, false}) {
      const JonesOrder order{std::string(name), eae, false, eae};
      const JonesRun run = run_jones(order);
      made.views.push_back(view_of(order, run));
      if (eae) made.elements.push_back(elements_of(order, run));
    }
  }
  made.pair_s = seconds(run_jones({"roberts", true, true, false}).view().time);
  for (const bool eae : {true, false}) {
    for (const char* const name : {"corridor8", "corridor32"}) {
      const JonesRun run = run_jones({name, eae, false, false});
      const jones::View& view = run.outcome.views.front();
      made.corridors.push_back({name, eae, run.scene.cells.size(), view.distinct_cells, view.visits, view.instructions,
                                seconds(view.time)});
    }
  }
  return made;
}

void jones_timing(Page& page, const JonesViews& jones) {
  using View = JonesView;
  paper_times(page, jones);
  paper_sizes(page, jones);
  page.table("jones-views", "Jones: computing time of the default views", jones.views,
             {{"scene", "Scene", &View::scene},
              {"eae", "EAE", &View::eae},
              {"first_view_s", "First view", "s", &View::first_view_s, 3},
              {"second_view_s", "Second view", "s", &View::second_view_s, 3},
              {"views_per_s", "Rate", "views/s", [](const View& view) { return 1 / view.second_view_s; }, 1},
              {"instructions", "Instructions", &View::instructions},
              {"lines_clipped", "Lines clipped", &View::lines_clipped},
              {"pieces", "Pieces drawn", &View::pieces},
              {"refreshes_per_s", "Refresh", "1/s", [](const View& view) { return 1 / view.refresh_s; }, 1}},
             {{"Views from other positions take longer: `sightline atlas street4 --views 1000` gives the times from random "
               "eyes.",
               "Seconds of the emulated PDP-7, from the start of the search to the moment the new display file is put in the "
               "place of the old. During the first view the display is dark; during the second it shows the first and takes "
               "cycles from the processor. A display file must equal the native twin's, word for word, or the report ends with "
               "an error."}});
  // The hidden part changes nothing: the photograph of corridor32 is that of corridor8.
  const auto drawing = [](const View& view) {
    return fmt::format("Hidden-line drawing of the scene {} on the Type 340, {} pieces of lines", view.scene, text_of(view.pieces));
  };
  page.gallery("jones-phosphor", "Jones: the screen, photographed",
               where(jones.views, [](const View& view) { return view.eae && view.scene != "corridor32"; }),
               [&](const View& view) {
                 return figure(*view.phosphor, "phosphor-" + view.scene, view.scene, both_times(jones, view),
                               drawing(view) + ", as the glowing screen shows it");
               });
  page.gallery("jones-screens", "Jones: the pictures, point by point", jones.of(true),
               [&](const View& view) {
                 return figure(*view.screen, "screen-" + view.scene, view.scene, both_times(jones, view), drawing(view));
               },
               true);
}

void jones_needs(Page& page, const JonesViews& jones) {
  using View = JonesView;
  using Corridor = JonesCorridor;
  const auto capacity = [](const View&) { return jones::core_words; };
  page.table("jones-core", "Jones: core and equipment, against capacity", jones.views,
             {{"scene", "Scene", &View::scene},
              {"devices", "Equipment", &View::devices},
              {"program_words", "Program", "words", &View::program_words},
              {"scene_words", "Scene", "words", &View::scene_words},
              {"used_words", "In all", "words", &View::used_words},
              {"core_words", "Capacity", "words", capacity},
              {"used_percent", "Used", "%",
               [](const View& view) { return 100.0 * static_cast<double>(view.used_words) / jones::core_words; }, 1},
              {"stack_words", "Stack", "words", &View::stack_words},
              {"stack_room_words", "Capacity", "words", [](const View&) { return jones::mask_stack_words; }},
              {"file_words", "Display file", "words", &View::file_words},
              {"file_room_words", "Capacity", "words", &View::file_room_words}},
             {{"In all: instructions, variables and constants, the scene, records of its openings, the mask stack and two "
               "display files of fixed size. The stack is the deepest of this view. The tape reader, from which the program "
               "was loaded, is not used while a view is computed."}});
  page.table("jones-work", "Jones: what a view reads", jones.views,
             {{"scene", "Scene", &View::scene},
              {"eae", "EAE", &View::eae},
              {"cells", "Cells", "in the scene", &View::cells},
              {"cells_read", "Cells", "read", &View::cells_read},
              {"visits", "Visits", &View::visits},
              {"depth", "Depth", "cells", &View::depth},
              {"openings", "Portals", "in the scene", &View::openings},
              {"openings_tested", "Portals", "tested", &View::openings_tested},
              {"masks", "Masks", "made", &View::masks},
              {"view_s", "View", "s", &View::second_view_s, 3},
              {"stolen_cycles", "Cycles stolen", "by the display", &View::stolen_cycles},
              {"stolen_percent", "Stolen", "% of the view",
               [](const View& view) {
                 return 100 * jones_cycle_us() * static_cast<double>(view.stolen_cycles) / (1000000 * view.second_view_s);
               },
               2}},
             {{"Cells read: cells of which the processor fetched any word, as observed by the emulator. A cell that is visible "
               "through several portals is visited once for each. Every display word that is shown costs the processor one "
               "cycle of " + text_of(jones_cycle_us()) + " us."}});
  const bool nothing = jones.unseen_rooms_cost_nothing() && distinct(jones.corridors, &Corridor::cells_read) == 1 &&
                       distinct(jones.corridors, &Corridor::visits) == 1;
  page.table("unseen-guest", "Jones on the PDP-7: a corridor whose invisible part grows", jones.corridors,
             {{"scene", "Scene", &Corridor::scene},
              {"eae", "EAE", &Corridor::eae},
              {"cells", "Cells", "in the scene", &Corridor::cells},
              {"cells_read", "Cells", "read", &Corridor::cells_read},
              {"visits", "Visits", &Corridor::visits},
              {"instructions", "Instructions", &Corridor::instructions},
              {"view_s", "First view", "s", &Corridor::view_s, 6}},
             {{"The first view, while the display takes no cycles. " +
               page.claim(nothing, "Rooms that are not visible cost no instructions; they only occupy core.")}});
}

}  // namespace sightline::report
