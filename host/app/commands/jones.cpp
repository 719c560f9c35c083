#include <fmt/core.h>

#include <memory>
#include <optional>
#include <utility>

#include "host/app/commands/commands.hpp"
#include "host/app/commands/jones_pictures.hpp"
#include "host/app/commands/machine_command.hpp"
#include "host/app/outputs.hpp"
#include "host/app/scene_argument.hpp"
#include "host/base/json.hpp"
#include "host/machines/pdp7_scripts.hpp"

namespace sightline::app {

namespace {

namespace jones = programs::jones;
using base::Json;

struct JonesArguments {
  std::string scene;
  bool no_eae = false;
  unsigned fraction = 3;
  bool truncate = false;
  std::string at;
  std::optional<int> scale;
  std::string switches;
  std::optional<std::string> walk;
  std::optional<int> turn;
  bool stereo = false;
  bool immediate = false;
  std::optional<int> views;
  std::string directory = "out";
  bool check = false;
  bool json = false;
};

constexpr double flicker_limit = 30.0;
constexpr std::string_view walk_by_switches = "switches";

jones::Order order_of(const JonesArguments& arguments) {
  jones::Order order;
  if (!arguments.at.empty()) order.eye = point_argument("--at", arguments.at);
  order.scale = arguments.scale;
  order.stereo = arguments.stereo;
  order.immediate = arguments.immediate;
  order.views = arguments.views.value_or(2);
  order.photograph = photograph_time;
  order.film = arguments.immediate;
  order.check = arguments.check;
  if (arguments.walk && arguments.walk != walk_by_switches) {
    if (arguments.views || !arguments.switches.empty()) throw base::usage_error("--walk: found steps, each of which is a view; --views and --switches need `--walk switches`");
    auto walk = jones::read_walk(*arguments.walk);
    if (!walk) throw base::usage_error("--walk: " + walk.error().message());
    order.walk = std::move(*walk);
  }
  order.angle = arguments.turn.value_or(0);
  if (!arguments.switches.empty()) {
    static_cast<void>(value_of(machines::read_switches(read_named(arguments.switches), order.switches)));
    // The switches of --stereo and --immediate stay up, whatever the script sets.
    const core::Word18 modes((arguments.stereo ? 1U : 0U) | (arguments.immediate ? 2U : 0U));
    for (auto& setting : order.switches) setting.switches = setting.switches | modes;
  }
  return order;
}

Json document_of(const JonesArguments& arguments, const jones::Build& build, const scene::CellScene& scene, const jones::Outcome& outcome,
                 const std::vector<std::string>& pictures) {
  Json document{{"schema", "sightline/jones/1"},
                {"scene", arguments.scene},
                {"eae", !arguments.no_eae},
                {"fraction_bits", arguments.fraction},
                {"truncated", arguments.truncate},
                {"walk", build.walk},
                {"rotation", build.rotation},
                {"eye", outcome.eye},
                {"cells", scene.cells.size()},
                {"core_words_used", outcome.core_words},
                {"refreshes_per_second", outcome.refreshes_per_second()},
                {"flicker", outcome.refreshes_per_second() < flicker_limit}};
  document["views"] = Json::array();
  for (const jones::View& view : outcome.views) {
    Json entry{{"status", jones::name(view.status)},
               {"emulated_ns", view.time.count()},
               {"instructions", view.instructions},
               {"stolen_cycles", view.stolen_cycles},
               {"cells_read", view.distinct_cells},
               {"visits", view.visits},
               {"openings_tested", view.openings_tested},
               {"lines_clipped", view.lines_clipped},
               {"segments", view.pieces},
               {"display_words", view.display_file.size()}};
    if (build.rotation) entry["angle"] = view.angle;
    if (build.walk) {
      entry["eye"] = view.eye;
      entry["cell"] = view.cell < scene.cells.size() ? Json(view.cell) : Json(nullptr);
      entry["stopped"] = Json::array();
      for (std::size_t axis = 0; axis < 3; ++axis)
        if ((view.stops >> axis & 1U) != 0) entry["stopped"].push_back(std::string(1, "xyz"[axis]));
    }
    document["views"].push_back(std::move(entry));
  }
  document["pictures"] = pictures;
  return document;
}

std::string summary_of(const JonesArguments& arguments, const jones::Build& build, const scene::CellScene& scene, const jones::Outcome& outcome) {
  const jones::View& view = outcome.view();
  const auto& eye = outcome.eye;
  std::string text = fmt::format("{} from {},{},{}, PDP-7 {} EAE\n", arguments.scene, eye[0], eye[1], eye[2],
                                 arguments.no_eae ? "without" : "with");
  for (std::size_t n = 0; n < outcome.views.size(); ++n) {
    const jones::View& each = outcome.views[n];
    text += fmt::format("{:<17}{:.3f} s{}", fmt::format("view {}", n + 1), core::in_seconds(each.time),
                        n == 0 ? " (display dark)" : " (picture being refreshed)");
    if (build.walk) {
      text += fmt::format(", eye {},{},{} in {}", each.eye[0], each.eye[1], each.eye[2],
                          each.cell < scene.cells.size() ? fmt::format("cell {}", each.cell) : "no cell");
    }
    if (build.rotation) text += fmt::format(", {} degrees", each.angle);
    if (each.stops != 0) text += fmt::format(", stopped by a wall along {}", jones::axes_of(each.stops));
    text += "\n";
  }
  text += fmt::format("status           {}\n", jones::name(view.status));
  text += fmt::format("instructions     {}\n", view.instructions);
  text += fmt::format("cells read       {} of {}, {} visits\n", view.distinct_cells,
                      scene.cells.size(), view.visits);
  text += fmt::format("openings tested  {}\n", view.openings_tested);
  text += fmt::format("lines clipped    {}\n", view.lines_clipped);
  text += fmt::format("segments         {}\n", view.pieces);
  text += fmt::format("display words    {}\n", view.display_file.size());
  text += fmt::format("core used        {} of {} words\n", outcome.core_words, jones::core_words);
  if (outcome.refresh_period.count() == 0) return text + "refresh          none: there is nothing to see\n";
  text += fmt::format("refresh          {:.1f} a second, {}\n", outcome.refreshes_per_second(),
                      outcome.refreshes_per_second() < flicker_limit ? "flickers" : "steady");
  return text;
}

ExitCode run_jones(const JonesArguments& arguments) {
  const scene::CellScene scene = load_cells(arguments.scene);
  const jones::Order order = order_of(arguments);
  jones::Build build{!arguments.no_eae, arguments.fraction, arguments.truncate};
  build.rotation = arguments.turn.has_value() || jones::has_turn(order.walk);
  build.walk = arguments.walk.has_value() || build.rotation;
  const jones::Outcome outcome = value_of(jones::run(scene, build, order), arguments.scene);
  const auto pictures = write_jones_pictures(arguments.directory, file_stem(scene.name),
                                             title_of(scene.name, build.eae), outcome);
  if (arguments.json) {
    print_json(document_of(arguments, build, scene, outcome, pictures));
  } else {
    write_stdout(summary_of(arguments, build, scene, outcome));
    for (const std::string& path : pictures) write_stdout(fmt::format("picture          {}\n", path));
  }
  if (arguments.check) report_equal(arguments.scene);
  const jones::Status status = outcome.view().status;
  if (status == jones::Status::complete) return ExitCode::ok;
  print_message(fmt::format("{}: the view stopped: {}; the pictures show what there was", arguments.scene,
                       jones::name(status)));
  return ExitCode::guest_failed;
}

}  // namespace

void add_jones_command(const Command& program) {
  const Command command = program.add_command("jones", help_page("jones"));
  const auto arguments = std::make_shared<JonesArguments>();
  command.option("SCENE", arguments->scene, cells_help).required();
  add_eae_options(command, arguments->no_eae);
  command.option("--fraction", arguments->fraction, "Fraction bits of the program's screen coordinates")
      .default_value()
      .range(0, 3);
  command.flag("--truncate", arguments->truncate, "Truncate quotients instead of rounding them");
  command.option("--at,--eye", arguments->at, "The camera position; its cell becomes the initial cell")
      .default_value("the scene's own view")
      .value("X,Y,Z");
  command.option("--scale", arguments->scale, "Scale factor; 512 shows 90 degrees")
      .default_value("512")
      .range(64, 4096);
  const Option switches = command.option("--switches", arguments->switches, "Script of the AC switches; - is standard input")
      .value("SCRIPT");
  command.option("--walk", arguments->walk, "Walk from cell to cell: the way to each further view, as \"in 100, right 50 up 20\", or \"switches\"")
      .value("STEPS");
  command.option("--turn", arguments->turn, "Turn the view to the right, or to the left if negative; the steps then follow the view")
      .value("DEGREES")
      .range(-360, 360);
  command.flag("--stereo", arguments->stereo, "A stereo pair: AC switch 17 up");
  command.flag("--immediate", arguments->immediate, "Add lines to the picture at once: AC switch 16 up; with a movie of view 1, SCENE.apng");
  command.option("--views", arguments->views, "Number of views to compute; the last one is shown")
      .default_value("2")
      .range(1, 1000);
  command.option("-o,--output", arguments->directory, "Folder for the pictures").default_value().value("DIR");
  command.flag("--check", arguments->check, "Compare the last view with that of the same program in C++, word for word")
      .excludes(switches);
  command.flag("--json", arguments->json, "One JSON document instead of the summary");
  command.run([arguments] { return run_jones(*arguments); });
}

}  // namespace sightline::app
