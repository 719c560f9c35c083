#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "host/app/commands/commands.hpp"
#include "host/app/commands/jones_pictures.hpp"
#include "host/app/outputs.hpp"
#include "host/app/scene_argument.hpp"
#include "host/base/json.hpp"
#include "host/picture/apng.hpp"
#include "host/picture/phosphor.hpp"
#include "host/picture/raster_image.hpp"
#include "host/picture/stroke_log.hpp"
#include "host/programs/turn/turn.hpp"

namespace sightline::app {

namespace {

namespace turn = programs::turn;
using base::Json;

struct TurnArguments {
  std::string model;
  bool no_eae = false;
  bool level = false;
  std::string memory = "8k";
  std::uint32_t frames = 0;
  std::string directory = "out";
  bool check = false;
  bool json = false;
};

// Half as wide and high; each pixel is the brightest of four.
picture::Image half_size(const picture::Image& image) {
  picture::Image half(image.width / 2, image.height / 2, 1);
  for (int row = 0; row < half.height; ++row)
    for (int column = 0; column < half.width; ++column)
      half.pixels[half.index(column, row)] = std::max(
          {image.pixels[image.index(2 * column, 2 * row)], image.pixels[image.index(2 * column + 1, 2 * row)],
           image.pixels[image.index(2 * column, 2 * row + 1)], image.pixels[image.index(2 * column + 1, 2 * row + 1)]});
  return half;
}

// Each picture is shown for the time that the machine took for the next one.
void write_animation(const std::string& path, const std::string& title, const turn::Pictures& run) {
  Output output(path);
  picture::ApngWriter apng({1, 25}, 0, {{"Title", title}, {"Software", "sightline"}});
  for (const turn::ShownPass& pass : run.shown) {
    if (pass.picture + 2 >= run.pictures.size()) break;  // the last pictures of the turn repeat the first ones
    const auto tenths = static_cast<std::uint16_t>(std::min<std::int64_t>(run.pictures[pass.picture + 2].time.count() / 100'000, 60000));
    const auto added = apng.add(half_size(picture::crisp_raster(pass.strokes)), {tenths, 10000});
    if (!added) throw base::usage_error(added.error().message());
  }
  const auto bytes = apng.finish();
  if (!bytes) throw base::usage_error(bytes.error().message());
  output.write(*bytes);
  output.commit();
}

std::vector<std::string> write_pictures(const TurnArguments& arguments, const std::string& name,
                                        const turn::Outcome& outcome) {
  make_directory(arguments.directory);
  const std::string base = (std::filesystem::path(arguments.directory) / (file_stem(name) + "-turn")).string();
  const std::string title = fmt::format("{} turning on the PDP-7 {} EAE, after Plantinga, Seales and Dyer 1990", name,
                                        arguments.no_eae ? "without" : "with");
  std::vector<std::string> paths{base + ".apng", base + "-phosphor.png", base + ".strokes"};
  write_animation(paths[0], title, outcome.hidden);
  const auto& shown = outcome.hidden.shown;
  const auto& last = shown[shown.size() / 8].strokes;
  // One picture, refreshed for a fifth of a second.
  picture::PhosphorPhotograph photograph(last.front().time, last.front().time + photograph_time);
  const double period = 1 / outcome.hidden.summary.refreshes_per_second;
  for (int n = 0; n * period < core::in_seconds(photograph_time); ++n)
    for (core::Stroke stroke : last) {
      stroke.time += core::Duration(static_cast<std::int64_t>(n * period * 1e9));
      photograph.stroke(stroke);
    }
  Output screen(paths[1]);
  write_png(screen, photograph.develop(),
            {{"Title", title}, {"Description", "one picture on the P7 screen, shutter open for 0.2 s"}, {"Software", "sightline"}});
  screen.commit();
  std::string log;
  for (const core::Stroke& stroke : last) picture::append_stroke_line(log, stroke);
  Output strokes(paths[2]);
  strokes.write(log);
  strokes.commit();
  return paths;
}

Json document_of(const TurnArguments& arguments, const turn::Tape& tape, const turn::Outcome& outcome,
                 const std::vector<std::string>& pictures) {
  const turn::Summary& hidden = outcome.hidden.summary;
  return Json{{"schema", "sightline/turn/1"},
              {"model", arguments.model},
              {"eae", !arguments.no_eae},
              {"memory", arguments.memory},
              {"edges", tape.edges},
              {"events", tape.events},
              {"core_words", outcome.core_words},
              {"frames_per_second_mean", hidden.frames_per_second_mean},
              {"frames_per_second_worst", hidden.frames_per_second_worst},
              {"wire_frames_per_second_mean", outcome.wire.summary.frames_per_second_mean},
              {"cost_against_wire_frame", outcome.cost_against_wire_frame()},
              {"t_junctions_mean", hidden.junctions_mean},
              {"waiting_fraction", hidden.waiting_fraction},
              {"refreshes_per_second", hidden.refreshes_per_second},
              {"turn_seconds", outcome.turn_seconds()},
              {"pictures", pictures}};
}

std::string summary_of(const TurnArguments& arguments, const turn::Tape& tape, const turn::Outcome& outcome) {
  const turn::Layout& layout = tape.layout;
  const turn::Summary& hidden = outcome.hidden.summary;
  const turn::Summary& wire = outcome.wire.summary;
  std::string text = fmt::format("{} turning on the PDP-7 {} EAE, {} of core\n", arguments.model,
                                 arguments.no_eae ? "without" : "with", arguments.memory);
  text += fmt::format("edges            {}, {} vertices\n", tape.edges, tape.vertices);
  text += fmt::format("events           {} in a turn, {} changes\n", tape.events, tape.changes);
  text += fmt::format("words of core    {}: program {}, vertices {}, edges {}, T-junctions {}, events {}, {} display files {}\n",
                      outcome.core_words, outcome.program_words, layout.vertices + layout.header, layout.edges,
                      layout.junctions, layout.events, tape.files, layout.display_files);
  const std::uint32_t of_turn = turn::pictures_of_turn(outcome.step) - 1;
  if (outcome.hidden.pictures.size() < of_turn) {
    text += fmt::format("measured         the first {} of the {} pictures of a turn; without --frames all\n",
                        outcome.hidden.pictures.size(), of_turn);
  } else {
    text += fmt::format("one turn         {:.2f} s, {} pictures\n", outcome.turn_seconds(), of_turn);
  }
  text += fmt::format("{:<17}{:>14}{:>14}\n", "", "hidden lines", "wire frame");
  const auto row = [&text](const char* name, const std::string& a, const std::string& b) {
    text += fmt::format("{:<17}{:>14}{:>14}\n", name, a, b);
  };
  const auto number = [](double value) { return fmt::format("{:.1f}", value); };
  row("frames/s, mean", number(hidden.frames_per_second_mean), number(wire.frames_per_second_mean));
  row("frames/s, worst", number(hidden.frames_per_second_worst), number(wire.frames_per_second_worst));
  row("computing, ms", number(hidden.computing_mean * 1e3), number(wire.computing_mean * 1e3));
  row("waiting, %", number(hidden.waiting_fraction * 100), number(wire.waiting_fraction * 100));
  row("refreshes/s", number(hidden.refreshes_per_second), number(wire.refreshes_per_second));
  row("lines", number(hidden.lines_mean), number(wire.lines_mean));
  row("T-junctions", number(hidden.junctions_mean), number(wire.junctions_mean));
  text += fmt::format("time of a picture {:.2f} of that of a wire frame\n", outcome.cost_against_wire_frame());
  return text;
}

ExitCode run_turn(const TurnArguments& arguments) {
  const scene::LoadedScene source = load_scene(arguments.model);
  const auto memory = arguments.memory == "32k" ? turn::Memory::words_32k : turn::Memory::words_8k;
  const turn::Tape tape = value_of(turn::make_tape(source.scene, memory, !arguments.level), arguments.model);
  const turn::Order order{
      .eae = !arguments.no_eae, .pictures = arguments.frames, .strokes = true, .check = arguments.check};
  const turn::Outcome outcome = value_of(turn::run(tape, order), arguments.model);
  const auto pictures =
      write_pictures(arguments, std::filesystem::path(arguments.model).stem().string(), outcome);
  if (arguments.json) {
    print_json(document_of(arguments, tape, outcome, pictures));
  } else {
    write_stdout(summary_of(arguments, tape, outcome));
    for (const std::string& path : pictures) write_stdout(fmt::format("picture          {}\n", path));
  }
  if (arguments.check) report_equal(arguments.model);
  const auto full = std::find_if(outcome.hidden.pictures.begin(), outcome.hidden.pictures.end(),
                                 [](const turn::Picture& p) { return p.status != turn::Status::right; });
  if (full == outcome.hidden.pictures.end()) return ExitCode::ok;
  print_message(fmt::format("{}: a display file was full at angle {:06o}; that picture shows what there was", arguments.model,
                       full->angle));
  return ExitCode::guest_failed;
}

}  // namespace

void add_turn_command(const Command& program) {
  const Command command = program.add_command("turn", help_page("turn"));
  const auto arguments = std::make_shared<TurnArguments>();
  command.option("MODEL", arguments->model, scene_help).required();
  add_eae_options(command, arguments->no_eae);
  command.option("--memory", arguments->memory, "Core of the machine").one_of({"8k", "32k"}).default_value();
  command.option("--frames", arguments->frames, "Number of pictures of each kind")
      .default_value("those of one turn")
      .range(4, 20000);
  command.flag("--level", arguments->level, "Do not tilt the model: its y axis is the axis of the turn");
  command.option("-o,--output", arguments->directory, "Folder for the pictures").default_value().value("DIR");
  command.flag("--check", arguments->check, "Compare every picture with that of the same program in C++, word for word");
  command.flag("--json", arguments->json, "One JSON document instead of the table");
  command.run([arguments] { return run_turn(*arguments); });
}

}  // namespace sightline::app
