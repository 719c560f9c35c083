#include <fmt/core.h>

#include <memory>
#include <optional>

#include "host/app/commands/commands.hpp"
#include "host/app/commands/jones_session.hpp"
#include "host/app/commands/machine_command.hpp"
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
  bool stereo = false;
  bool immediate = false;
  int views = 2;
  std::string directory = "out";
  bool json = false;
};

constexpr double flicker_limit = 30.0;

jones::Session session_for(const scene::CellScene& scene, const JonesArguments& arguments) {
  jones::ProgramOptions options;
  options.eae = !arguments.no_eae;
  options.fraction_bits = arguments.fraction;
  options.truncate = arguments.truncate;
  if (!arguments.at.empty()) options.tape.view = point_argument("--at", arguments.at);
  return session_of(scene, arguments.scene, options);
}

jones::GuestOptions guest_options(const JonesArguments& arguments) {
  jones::GuestOptions options;
  options.scale = arguments.scale;
  options.stereo = arguments.stereo;
  options.immediate = arguments.immediate;
  options.views = arguments.views;
  options.photograph = photograph_time;
  if (!arguments.switches.empty()) {
    static_cast<void>(value_of(machines::read_switches(read_named(arguments.switches), options.switches)));
    // The modes asked for on the command line stay up whatever else the script does.
    const core::Word18 modes((arguments.stereo ? 1U : 0U) | (arguments.immediate ? 2U : 0U));
    for (auto& setting : options.switches) setting.switches = setting.switches | modes;
  }
  return options;
}

Json document_of(const JonesArguments& arguments, const jones::Program& program, const jones::GuestRun& run,
                 const std::vector<std::string>& pictures) {
  Json document{{"schema", "sightline/jones/1"},
                {"scene", arguments.scene},
                {"eae", !arguments.no_eae},
                {"fraction_bits", arguments.fraction},
                {"truncated", arguments.truncate},
                {"eye", program.scene.view.eye},
                {"cells", program.scene.cell_addresses.size()},
                {"core_words_used", program.words_used},
                {"refreshes_per_second", refreshes_per_second(run)},
                {"flicker", refreshes_per_second(run) < flicker_limit}};
  document["views"] = Json::array();
  for (const jones::GuestView& view : run.views) {
    document["views"].push_back({{"status", jones::name(view.status)},
                                 {"emulated_ns", view.time.count()},
                                 {"instructions", view.instructions},
                                 {"stolen_cycles", view.stolen_cycles},
                                 {"cells_read", view.distinct_cells},
                                 {"visits", view.visits},
                                 {"openings_tested", view.openings_tested},
                                 {"lines_clipped", view.lines_clipped},
                                 {"segments", view.pieces},
                                 {"display_words", view.display_file.size()}});
  }
  document["pictures"] = pictures;
  return document;
}

std::string summary_of(const JonesArguments& arguments, const jones::Program& program,
                       const jones::GuestRun& run) {
  const jones::GuestView& view = run.views.back();
  const auto& eye = program.scene.view.eye;
  std::string text = fmt::format("{} from {},{},{}, PDP-7 {} EAE\n", arguments.scene, eye[0], eye[1], eye[2],
                                 arguments.no_eae ? "without" : "with");
  for (std::size_t n = 0; n < run.views.size(); ++n)
    text += fmt::format("view {}           {:.3f} s{}\n", n + 1, seconds(run.views[n].time),
                        n == 0 ? " (display dark)" : " (picture being refreshed)");
  text += fmt::format("status           {}\n", jones::name(view.status));
  text += fmt::format("instructions     {}\n", view.instructions);
  text += fmt::format("cells read       {} of {}, {} visits\n", view.distinct_cells,
                      program.scene.cell_addresses.size(), view.visits);
  text += fmt::format("openings tested  {}\n", view.openings_tested);
  text += fmt::format("lines clipped    {}\n", view.lines_clipped);
  text += fmt::format("segments         {}\n", view.pieces);
  text += fmt::format("display words    {}\n", view.display_file.size());
  text += fmt::format("core used        {} of {} words\n", program.words_used, programs::jones::core_words);
  if (run.refresh_period.count() == 0) return text + "refresh          none: there is nothing to see\n";
  text += fmt::format("refresh          {:.1f} a second, {}\n", refreshes_per_second(run),
                      refreshes_per_second(run) < flicker_limit ? "flickers" : "steady");
  return text;
}

ExitCode run_jones(const JonesArguments& arguments) {
  const scene::CellScene scene = load_cells(arguments.scene);
  const jones::Session session = session_for(scene, arguments);
  const jones::Program& program = session.program();
  const jones::CheckedRun checked = session.run(guest_options(arguments));
  const jones::GuestRun& result = checked.guest;
  if (result.timed_out || result.views.empty()) {
    complain(fmt::format("{}: the program did not complete a view in {:.0f} emulated seconds",
                         arguments.scene, seconds(result.emulated)));
    return ExitCode::guest_failed;
  }
  // A script of the switches moves the eye between views, where the twin cannot follow.
  if (arguments.switches.empty()) require_twin(checked, arguments.scene);
  const auto pictures = write_jones_pictures(arguments.directory, file_stem(scene.name),
                                             title_of(scene.name, !arguments.no_eae), result);
  if (arguments.json) {
    print_json(document_of(arguments, program, result, pictures));
  } else {
    write_stdout(summary_of(arguments, program, result));
    for (const std::string& path : pictures) write_stdout(fmt::format("picture          {}\n", path));
  }
  const jones::Status status = result.views.back().status;
  if (status == jones::Status::complete) return ExitCode::ok;
  complain(fmt::format("{}: the view stopped: {}; the pictures show what there was", arguments.scene,
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
  command.flag("--truncate", arguments->truncate, "Truncate quotients where the program rounds them");
  command.option("--at,--eye", arguments->at, "The eye; the cell it is in becomes the initial cell")
      .default_value("the scene's own view")
      .value("X,Y,Z");
  command.option("--scale", arguments->scale, "Scale factor; 512 shows 90 degrees")
      .default_value("512")
      .range(64, 4096);
  command.option("--switches", arguments->switches, "Script of the AC switches; - is standard input")
      .value("SCRIPT");
  command.flag("--stereo", arguments->stereo, "A stereo pair: AC switch 17 up");
  command.flag("--immediate", arguments->immediate, "Add lines to the picture at once: AC switch 16 up");
  command.option("--views", arguments->views, "How many views to compute; the last is shown")
      .default_value()
      .range(1, 1000);
  command.option("-o,--output", arguments->directory, "Folder for the pictures").default_value().value("DIR");
  command.flag("--json", arguments->json, "One JSON document instead of the summary");
  command.run([arguments] { return run_jones(*arguments); });
}

}  // namespace sightline::app
