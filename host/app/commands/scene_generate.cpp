// See scene_generate.hpp.
#include "host/app/commands/scene_generate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "host/app/commands/scene_poly.hpp"
#include "host/scene/generate/scene.hpp"

namespace sightline::app {

namespace {

struct GenerateArguments {
  std::string family;
  std::size_t size = 1;
  std::uint64_t seed = 1;
  std::string output = "-";
};

constexpr const char* generate_examples =
    "Examples:\n"
    "  sightline scene generate boxes 100 -o boxes-100.json\n"
    "  sightline scene generate rooms 4 --seed 7 -o rooms.json\n"
    "      the same family, size and seed give the same scene everywhere\n";

// What SIZE counts; scene/generate_scene.hpp says what the families look like.
struct FamilyHelp {
  std::string_view family;
  std::string_view size;
};
constexpr std::array family_helps{
    FamilyHelp{"boxes", "SIZE boxes anywhere that touch nowhere"},
    FamilyHelp{"edgeon", "SIZE such boxes, looked at from the plane of a face"},
    FamilyHelp{"touch", "SIZE x SIZE x SIZE cubes that share faces"},
    FamilyHelp{"aligned", "SIZE x SIZE x SIZE cubes in rows, apart"},
    FamilyHelp{"town", "SIZE buildings on the ground"},
    FamilyHelp{"triangles", "SIZE triangles"},
    FamilyHelp{"bricks", "SIZE small boxes that may touch, fewer where there is no room"},
    FamilyHelp{"rooms", "SIZE x SIZE rooms with doors and hatches"},
    FamilyHelp{"big_rooms", "SIZE x SIZE such rooms, all lengths divided by 5"},
    FamilyHelp{"corridors", "SIZE rooms one behind the other"},
    FamilyHelp{"prisms", "SIZE turned houses of one height"},
};

std::string families_help() {
  std::string text = "\nFamilies:\n";
  for (const std::string_view name : scene::generator_names()) {
    const auto* const row = std::find_if(family_helps.begin(), family_helps.end(),
                                         [name](const FamilyHelp& help) { return help.family == name; });
    text += fmt::format("  {:<9}  {}, at most {}\n", name, row == family_helps.end() ? "SIZE" : row->size,
                        scene::largest_generated_size(name));
  }
  return text +
         "\nFAMILY-SIZE or FAMILY-SIZE-SEED names such a scene in place of a file for all commands but "
         "`jones` and `scene tape`, which want a scene of cells.\n";
}

void generate(const GenerateArguments& arguments) {
  auto scene = scene::generate_scene(arguments.family, arguments.size, arguments.seed);
  if (!scene) throw Failure(ExitCode::usage, scene.error().message());
  write_scene(*scene, arguments.family, arguments.output);
}

}  // namespace

void add_scene_generate(const Command& scene_command) {
  const Command command = scene_command.add_command("generate", "Write a scene of a random family");
  const auto arguments = std::make_shared<GenerateArguments>();
  command.option("FAMILY", arguments->family, "One of those below").required();
  command.option("SIZE", arguments->size, "How many of what: see below")
      .check(why_no_whole_number)
      .required();
  command.option("--seed", arguments->seed, "Another seed, another scene")
      .check(why_no_whole_number)
      .default_value()
      .value("N");
  command.option("-o,--output", arguments->output, "A .json, .off or .obj file; - is JSON on standard output")
      .default_value()
      .value("FILE");
  command.footer(generate_examples + families_help());
  command.run([arguments] {
    generate(*arguments);
    return ExitCode::ok;
  });
}

}  // namespace sightline::app
