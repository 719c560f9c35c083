// See scene_compartment_command.hpp.
//
// The file it writes, "sightline/cell-complex/1", is a CellComplex (host/scene/cell_complex.hpp) as JSON. A
// plane is [x, y, z, offset] of its normal and offset. A half-space is a number: n >= 0 where plane n is not
// positive, -1 - n where plane n is not negative. A line is [edge, a, b, c, d]: from a/b to c/d of the edge.
// The cell outside is null.
#include "host/app/scene_compartment_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "host/app/scene_source.hpp"
#include "host/scene/check_complex.hpp"
#include "host/scene/compartment.hpp"

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
    "  sightline scene compartment part.off -o cells.json\n"
    "      the cells themselves: planes, half-spaces, openings, parts of edges\n\n"
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

const char* method_name(scene::CompartmentMethod method) {
  return method == scene::CompartmentMethod::bsp ? "bsp" : "grid";
}

// Writes a document piece by piece: that of a large scene is longer than the scene itself.
class ComplexWriter {
 public:
  ComplexWriter(Output& output, const scene::CellComplex& complex) : output_(output), complex_(complex) {}

  void write(std::string_view scene, std::string_view method) {
    add("{{\n\"schema\": \"sightline/cell-complex/1\",\n\"scene\": {},\n\"method\": \"{}\",\n\"outer\": ",
        nlohmann::json(scene).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace), method);
    add("[[{}], [{}]],\n", fmt::join(complex_.outer.low, ", "), fmt::join(complex_.outer.high, ", "));
    list("vertices", complex_.vertices, [&](const auto& v) { add("[{}]", fmt::join(v, ", ")); });
    add(",\n");
    list("edges", complex_.edges, [&](const auto& edge) { add("[{}, {}]", edge.from, edge.to); });
    add(",\n");
    list("planes", complex_.planes,
         [&](const auto& plane) { add("[{}, {}]", fmt::join(plane.normal, ", "), plane.offset); });
    add(",\n");
    list("cells", complex_.cells, [&](const auto& cell) { write_cell(cell); });
    add(",\n");
    list("openings", complex_.openings, [&](const auto& opening) { write_opening(opening); });
    add("\n}}\n");
    flush();
  }

 private:
  template <class... Parts>
  void add(fmt::format_string<Parts...> format, Parts&&... parts) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Parts>(parts)...);
    if (text_.size() > std::size_t{1} << 20) flush();
  }
  void flush() {
    output_.write(text_);
    text_.clear();
  }
  template <class Rows, class Write>
  void list(std::string_view name, const Rows& rows, Write write) {
    add("\"{}\": [", name);
    bool first = true;
    for (const auto& row : rows) {
      add("{}", first ? "\n" : ",\n");
      first = false;
      write(row);
    }
    add("]");
  }
  void halves(std::string_view name, std::span<const scene::HalfSpace> halves) {
    add("\"{}\": [", name);
    for (const scene::HalfSpace& half : halves) {
      const std::int64_t plane = half.plane;
      add("{}{}", &half == halves.data() ? "" : ", ", half.turned ? -1 - plane : plane);
    }
    add("]");
  }
  void write_cell(const scene::ComplexCell& cell) {
    add("{{");
    halves("bounds", complex_.bounds_of(cell));
    add(", \"lines\": [");
    const auto lines = complex_.lines_of(cell);
    for (const scene::ComplexLine& line : lines) {
      add("{}[{}, {}, {}, {}, {}]", &line == lines.data() ? "" : ", ", line.edge, line.low.numerator(),
          line.low.denominator(), line.high.numerator(), line.high.denominator());
    }
    add("], \"openings\": [{}]}}", fmt::join(complex_.openings_of(cell), ", "));
  }
  void write_opening(const scene::ComplexOpening& opening) {
    const auto cell = [](scene::CellNumber number) {
      return number == scene::outside ? std::string("null") : std::to_string(number);
    };
    add("{{\"cells\": [{}, {}], \"plane\": {}, ", cell(opening.cells[0]), cell(opening.cells[1]),
        opening.plane);
    halves("sides", complex_.sides_of(opening));
    add("}}");
  }

  Output& output_;
  const scene::CellComplex& complex_;
  std::string text_;
};

void describe(const CompartmentArguments& arguments, const scene::Compartments& result) {
  const scene::CellComplex& complex = result.complex;
  const auto outer = std::count_if(complex.openings.begin(), complex.openings.end(), [](const auto& opening) {
    return opening.cells[0] == scene::outside || opening.cells[1] == scene::outside;
  });
  if (arguments.json) {
    const nlohmann::ordered_json document{{"schema", "sightline/scene-compartment/1"},
                                          {"scene", arguments.scene},
                                          {"method", method_name(result.method)},
                                          {"cells", complex.cells.size()},
                                          {"openings", complex.openings.size()},
                                          {"openings_outside", outer},
                                          {"lines", complex.lines.size()},
                                          {"edges", complex.edges.size()},
                                          {"planes", complex.planes.size()}};
    write_stdout(document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
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
  if (auto* error = std::get_if<scene::SceneError>(&result)) {
    error->source = arguments.scene;
    throw Failure(ExitCode::bad_input, error->message());
  }
  const auto& compartments = std::get<scene::Compartments>(result);
  const auto errors = scene::check_complex(compartments.complex, source.scene);
  for (const scene::SceneError& error : errors) complain(error.message());
  if (!errors.empty()) return ExitCode::differs;
  if (output) {
    ComplexWriter(*output, compartments.complex).write(arguments.scene, method_name(compartments.method));
    output->commit();
  }
  if (!output || !output->is_stdout()) describe(arguments, compartments);
  return ExitCode::ok;
}

}  // namespace

void add_scene_compartment_command(CLI::App& scene_command, ExitCode& exit_code) {
  CLI::App* const command =
      scene_command.add_subcommand("compartment", "Cut a scene's free space into cells and openings");
  const auto arguments = std::make_shared<CompartmentArguments>();
  command->add_option("SCENE", arguments->scene, std::string(scene_source_help))->required();
  command->add_option("--method", arguments->method, "auto, grid or bsp")
      ->check(CLI::IsMember({"auto", "grid", "bsp"}))
      ->capture_default_str()
      ->type_name("METHOD");
  command
      ->add_option("-o,--output", arguments->output,
                   "Where the cells go as JSON; - is standard output, without the counts")
      ->type_name("FILE");
  command->add_flag("--json", arguments->json, "The counts as one JSON document");
  command->footer(compartment_examples);
  command->callback([arguments, &exit_code] { exit_code = run_compartment(*arguments); });
}

}  // namespace sightline::app
