// See scene_compartment.hpp. The file it writes is that of host/scene/read/cell_complex_file.hpp.
#include "host/app/commands/scene_compartment.hpp"

#include <fmt/format.h>

#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "host/app/commands/scene_info.hpp"
#include "host/app/scene_source.hpp"
#include "host/base/json.hpp"
#include "host/base/result.hpp"
#include "host/scene/cells/decompose.hpp"
#include "host/scene/check/cell_complex.hpp"
#include "host/scene/read/cell_complex_file.hpp"

namespace sightline::app {
namespace {

struct CompartmentArguments {
  std::string scene;
  std::string method = "auto";
  std::string output;
  bool json = false;
};

constexpr const char* compartment_examples =
    "Examples:\n"
    "  sightline scene compartment boxes-100\n"
    "      how many cells, openings and lines there are\n"
    "  sightline scene compartment part.off -o part.cells.json\n"
    "      the cells themselves: planes, half-spaces, openings, parts of edges; and the scene, so that\n"
    "      `sightline draw jones part.cells.json -o part.svg` draws it without cutting it again, and\n"
    "      `sightline scene check` and `info` know it\n\n"
    "grid grows boxes between faces parallel to the axes, up to ten million units of the grid; bsp cuts "
    "space "
    "by the\n"
    "planes of the faces of any polyhedra; auto takes grid where it can. The result is checked: exit code 1 "
    "if "
    "it is\n"
    "not a possible one.\n";

const std::map<std::string, scene::CompartmentMethod> method_names{
    {"auto", scene::CompartmentMethod::automatic},
    {"grid", scene::CompartmentMethod::grid},
    {"bsp", scene::CompartmentMethod::bsp}};

void describe(const CompartmentArguments& arguments, const scene::Compartments& result) {
  const scene::CellComplex& complex = result.complex;
  const std::size_t outer = openings_outside(complex);
  if (arguments.json) {
    const base::Json document{{"schema", "sightline/scene-compartment/1"},
                              {"scene", arguments.scene},
                              {"method", method_name(result.method)},
                              {"cells", complex.cells.size()},
                              {"openings", complex.openings.size()},
                              {"openings_outside", outer},
                              {"lines", complex.lines.size()},
                              {"edges", complex.edges.size()},
                              {"planes", complex.planes.size()}};
    print_json(document);
    return;
  }
  write_stdout(fmt::format("method    {}\n", method_name(result.method)));
  write_stdout(fmt::format("cells     {}\n", complex.cells.size()));
  write_stdout(fmt::format("openings  {}, {} of them to outside\n", complex.openings.size(), outer));
  write_stdout(fmt::format("lines     {}, parts of {} edges\n", complex.lines.size(), complex.edges.size()));
  write_stdout(fmt::format("planes    {}\n", complex.planes.size()));
}

ExitCode run_compartment(const CompartmentArguments& arguments) {
  std::unique_ptr<Output> output;
  if (!arguments.output.empty()) output = std::make_unique<Output>(arguments.output);
  const SceneSource source = load_scene_source(arguments.scene);
  auto result = scene::compartments_of(source.scene, method_names.at(arguments.method));
  if (!result) {
    result.error().file = arguments.scene;
    throw Failure(ExitCode::bad_input, result.error().message());
  }
  const auto& compartments = *result;
  const auto errors = scene::check_complex(compartments.complex, source.scene);
  for (const base::Error& error : errors) complain(error.message());
  if (!errors.empty()) return ExitCode::differs;
  if (output) {
    scene::write_cell_complex(source.scene, compartments,
                              [&](std::string_view text) { output->write(text); });
    output->commit();
  }
  if (!output || !output->is_stdout()) describe(arguments, compartments);
  return ExitCode::ok;
}

}  // namespace

void add_scene_compartment_command(const Command& scene_command) {
  const Command command =
      scene_command.add_command("compartment", "Cut a scene's free space into cells and openings");
  const auto arguments = std::make_shared<CompartmentArguments>();
  command.option("SCENE", arguments->scene, scene_source_help).required();
  command.option("--method", arguments->method, "How space is cut")
      .one_of({"auto", "grid", "bsp"})
      .default_value()
      .value("METHOD");
  command
      .option("-o,--output", arguments->output,
              "Where the cells go as JSON; - is standard output, without the counts")
      .value("FILE");
  command.flag("--json", arguments->json, "The counts as one JSON document");
  command.footer(compartment_examples);
  command.run([arguments] { return run_compartment(*arguments); });
}

}  // namespace sightline::app
