#include <memory>
#include <string>
#include <string_view>

#include "host/app/commands/commands.hpp"
#include "host/app/commands/scene_check.hpp"
#include "host/app/commands/scene_compartment.hpp"
#include "host/app/commands/scene_generate.hpp"
#include "host/app/commands/scene_info.hpp"
#include "host/app/commands/scene_poly.hpp"
#include "host/app/scene_argument.hpp"
#include "host/app/scene_source.hpp"
#include "host/base/json.hpp"
#include "host/guests/jones/encode.hpp"
#include "host/scene/read/builtin.hpp"

namespace sightline::app {

namespace {

using base::Json;

struct SceneArguments {
  std::string scene;
  std::string at;
  std::string output = "-";
  bool json = false;
};

// --- tape

constexpr const char* tape_examples =
    "Examples:\n"
    "  sightline scene tape house -o house.s\n"
    "      the source tape that is assembled together with Jones's program\n"
    "  sightline scene tape my-room.json --at 120,60,30 -o room.s\n"
    "      a scene of your own, seen from another point; its cell becomes the initial one\n\n"
    "--at takes decimal numbers; x points right, y up, z away from the viewer. A point inside a solid, "
    "outside\n"
    "everything, or too near the far side of its cell is an error.\n";

void tape(const SceneArguments& arguments) {
  guests::jones::TapeOptions options;
  if (!arguments.at.empty()) options.view = point_argument("--at", arguments.at);
  const scene::CellScene scene = load_scene(arguments.scene);
  auto text = guests::jones::write_tape(scene, options);
  if (!text) {
    text.error().file = arguments.scene;
    throw Failure(ExitCode::bad_input, text.error().message());
  }
  Output output(arguments.output);
  output.write(*text);
  output.commit();
}

void add_tape(const Command& parent) {
  const Command command = parent.add_command("tape", "Write a scene as a source tape of Jones's program");
  const auto arguments = std::make_shared<SceneArguments>();
  command.option("SCENE", arguments->scene, scene_argument_help).required();
  command.option("--at,--eye", arguments->at, "The eye").default_value("the scene's own view").value("X,Y,Z");
  command.option("-o,--output", arguments->output, "Where the tape goes; - is standard output")
      .default_value()
      .value("FILE");
  command.footer(tape_examples);
  command.run([arguments] {
    tape(*arguments);
    return ExitCode::ok;
  });
}

// --- check

constexpr const char* check_examples =
    "Examples:\n"
    "  sightline scene check my-room.json\n"
    "      every error on a line: file, cell, opening or solid, and what is wrong with it\n"
    "  sightline scene check --json my-room.json\n"
    "      the same as one JSON document, for a program\n\n"
    "Checked, exactly: cells and solids overlap nowhere and fill the outer box; every opening is shared by "
    "its two\n"
    "cells and its outline closes; every point of every face is opaque or in one opening; lines lie on their "
    "cell; the\n"
    "default view is in a cell. Of polyhedra: faces are planar and simple, holes inside them, solids closed "
    "and facing\n"
    "outwards, no vertex twice or for nothing, the camera's eye in free space. Of cells cut by `sightline "
    "scene\n"
    "compartment`: the polyhedra, and that cells and openings are a possible cutting of the space between "
    "them.\n"
    "A scene with errors ends with exit code 4.\n";

ExitCode check(const SceneArguments& arguments) {
  const SceneText file = read_scene_text(arguments.scene);
  const auto [errors, changes] = check_scene_text(file);
  if (arguments.json) {
    Json document{{"schema", "sightline/scene-check/1"}, {"scene", file.name}, {"possible", errors.empty()}};
    document["errors"] = Json::array();
    for (const auto& error : errors)
      document["errors"].push_back({{"place", error.place}, {"cause", error.found}});
    print_json(document);
  } else {
    for (const auto& error : errors) complain(error.message());
    tell(changes);
    if (errors.empty()) write_stdout(file.name + ": a possible scene\n");
  }
  return errors.empty() ? ExitCode::ok : ExitCode::bad_input;
}

void add_check(const Command& parent) {
  const Command command = parent.add_command("check", "Say everything that is wrong with a scene");
  const auto arguments = std::make_shared<SceneArguments>();
  command.option("SCENE", arguments->scene, scene_source_help).required();
  command.flag("--json", arguments->json, "One JSON document instead of lines");
  command.footer(check_examples);
  command.run([arguments] { return check(*arguments); });
}

// --- info

constexpr const char* info_examples =
    "Examples:\n"
    "  sightline scene info street4\n"
    "      how many cells, openings and lines, and how much of core they take\n"
    "  sightline scene info --json street4\n"
    "      the same as one JSON document\n"
    "  sightline scene info part.cells.json\n"
    "      of cells cut by `sightline scene compartment`, and of the polyhedra they were made of\n";

void add_info(const Command& parent) {
  const Command command = parent.add_command("info", "Describe a scene");
  const auto arguments = std::make_shared<SceneArguments>();
  command.option("SCENE", arguments->scene, scene_source_help).required();
  command.flag("--json", arguments->json, "One JSON document instead of lines");
  command.footer(info_examples);
  command.run([arguments] {
    describe_scene_text(read_scene_text(arguments->scene), arguments->json);
    return ExitCode::ok;
  });
}

// --- list

constexpr const char* list_examples =
    "Examples:\n"
    "  sightline scene list\n"
    "  for s in $(sightline scene list); do sightline scene info $s; done\n";

void add_list(const Command& parent) {
  const Command command = parent.add_command("list", "The names of the built-in scenes");
  const auto arguments = std::make_shared<SceneArguments>();
  command.flag("--json", arguments->json, "One JSON document instead of lines");
  command.footer(list_examples);
  command.run([arguments] {
    const auto names = scene::builtin_scene_names();
    if (arguments->json) {
      const Json document{{"schema", "sightline/scene-list/1"}, {"scenes", names}};
      print_json(document);
    } else {
      for (const std::string_view name : names) write_stdout(std::string(name) + "\n");
    }
    return ExitCode::ok;
  });
}

}  // namespace

void add_scene_command(const Command& program) {
  const Command command = program.add_command(
      "scene", "Scenes: list, check, describe, convert, generate, cut into cells, write as a tape");
  command.footer(
      "Examples:\n"
      "  sightline scene info house\n"
      "  sightline scene tape house -o house.s\n"
      "  sightline scene check part.off\n");
  add_tape(command);
  add_check(command);
  add_info(command);
  add_list(command);
  add_scene_convert(command);
  add_scene_generate(command);
  add_scene_compartment_command(command);
}

}  // namespace sightline::app
