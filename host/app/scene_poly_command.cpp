// See scene_poly_command.hpp.
#include "host/app/scene_poly_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "host/app/scene_argument.hpp"
#include "host/app/scene_source.hpp"
#include "host/scene/builtin.hpp"
#include "host/scene/eye_place.hpp"
#include "host/scene/poly_check.hpp"
#include "host/scene/poly_file.hpp"
#include "host/scene/poly_from_cells.hpp"
#include "host/scene/poly_shells.hpp"
#include "host/scene/read_poly_json.hpp"

namespace sightline::app {

namespace {

using nlohmann::ordered_json;

scene::PolyFormat input_format(const std::string& file) {
  return scene::poly_format_of(file).value_or(scene::PolyFormat::json);
}

std::variant<scene::PolyImport, scene::SceneError> read_file(const SceneText& file, bool mend) {
  return scene::read_poly(file.text, file.name, input_format(file.name), {mend});
}

struct ConvertArguments {
  std::string scene;
  std::string output = "-";
  bool mend = false;
};

constexpr const char* convert_examples =
    "Examples:\n"
    "  sightline scene convert part.off -o part.json\n"
    "  sightline scene convert house -o house.obj\n"
    "      a built-in scene of cells: its solids and walls as polyhedra\n"
    "  sightline scene convert --mend scan.obj -o clean.off\n"
    "      equal vertices merged, unused ones and faces without area left out, bodies turned the right side "
    "out\n\n"
    "Coordinates that are not whole numbers below 262144 are rounded once; the step is reported. OFF and OBJ "
    "have no holes: faces with holes are written there as triangles. OFF does not say which faces make a "
    "body: what "
    "hangs "
    "together is one.\n";

void convert(const ConvertArguments& arguments) {
  const SceneText file = read_scene_text(arguments.scene);
  if (arguments.mend && (file.builtin || input_format(file.name) == scene::PolyFormat::json)) {
    throw Failure(ExitCode::usage, fmt::format("--mend: found {}, expected an OFF or OBJ file", file.name));
  }
  if (!file.polyhedra) {
    write_scene(scene::poly_scene_of(load_scene(file.text, file.name)), file.name, arguments.output);
    return;
  }
  const scene::PolyImport import = load_poly_file(file, arguments.mend);
  tell(import.report);
  write_scene(import.scene, file.name, arguments.output);
}

}  // namespace

void write_scene(const scene::PolyScene& scene, const std::string& source, const std::string& path) {
  const auto format = scene::poly_format_of(path);
  if (!format && path != "-") {
    throw Failure(
        ExitCode::usage,
        fmt::format("--output: found \"{}\", expected a name that ends in .json, .off or .obj", path));
  }
  auto text = scene::write_poly(scene, format.value_or(scene::PolyFormat::json));
  if (auto* error = std::get_if<scene::SceneError>(&text)) {
    error->source = source;
    throw Failure(ExitCode::bad_input, error->message());
  }
  Output output(path);
  output.write(std::get<std::string>(text));
  output.commit();
}

void tell(const scene::PolyImportReport& report) {
  if (report.quantised)
    warn(
        fmt::format("coordinates rounded to a step of {}, by at most {}", report.step, report.largest_shift));
  if (report.split_faces > 0) {
    warn(fmt::format("{} faces that are not planar became triangles, the farthest vertex {} off",
                     report.split_faces, report.largest_deviation));
  }
  if (report.merged_vertices > 0) warn(fmt::format("{} equal vertices merged", report.merged_vertices));
  if (report.dropped_vertices > 0) warn(fmt::format("{} unused vertices left out", report.dropped_vertices));
  if (report.dropped_faces > 0) warn(fmt::format("{} faces without area left out", report.dropped_faces));
  if (report.turned_bodies > 0)
    warn(fmt::format("{} bodies turned the right side out", report.turned_bodies));
}

scene::PolyImport load_poly_file(const SceneText& file, bool mend) {
  auto read = read_file(file, mend);
  if (const auto* error = std::get_if<scene::SceneError>(&read))
    throw Failure(ExitCode::bad_input, error->message());
  auto import = std::get<scene::PolyImport>(std::move(read));
  auto errors = scene::check_poly_scene(import.scene);
  if (!errors.empty()) {
    errors.front().source = file.name;
    const std::string more =
        errors.size() > 1 ? fmt::format(" (the first of {} errors)", errors.size()) : std::string();
    throw Failure(ExitCode::bad_input, errors.front().message() + more);
  }
  return import;
}

SceneText read_scene_text(const std::string& name_or_file) {
  if (const auto generated = generated_scene(name_or_file)) {
    auto text = scene::write_poly(*generated, scene::PolyFormat::json);
    return {name_or_file, std::get<std::string>(std::move(text)), false, true};
  }
  require_scene_exists(name_or_file);
  if (const auto builtin = scene::builtin_scene_text(name_or_file))
    return {name_or_file, std::string(*builtin), true, false};
  SceneText file{name_or_file, read_input_text(name_or_file), false, false};
  file.polyhedra = input_format(file.name) != scene::PolyFormat::json || scene::is_poly_json(file.text);
  return file;
}

ExitCode check_poly_file(const SceneText& file, bool json) {
  const auto read = read_file(file, false);
  std::vector<scene::SceneError> errors;
  if (const auto* error = std::get_if<scene::SceneError>(&read)) {
    errors.push_back(*error);
  } else {
    const scene::PolyScene& scene = std::get<scene::PolyImport>(read).scene;
    errors = scene::check_poly_scene(scene);
    // Where the eye is, is known only among bodies that are in order.
    if (errors.empty()) {
      if (auto eye = scene::eye_error(scene, scene.camera)) errors.push_back(std::move(*eye));
    }
  }
  for (scene::SceneError& error : errors) error.source = file.name;
  if (json) {
    ordered_json document{
        {"schema", "sightline/scene-check/1"}, {"scene", file.name}, {"possible", errors.empty()}};
    document["errors"] = ordered_json::array();
    for (const auto& error : errors)
      document["errors"].push_back({{"place", error.place}, {"cause", error.cause}});
    write_stdout(document.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n");
  } else {
    for (const auto& error : errors) complain(error.message());
    if (const auto* import = std::get_if<scene::PolyImport>(&read)) tell(import->report);
    if (errors.empty()) write_stdout(file.name + ": a possible scene\n");
  }
  return errors.empty() ? ExitCode::ok : ExitCode::bad_input;
}

void describe_poly_file(const SceneText& file, bool json) {
  const scene::PolyImport import = load_poly_file(file, false);
  const scene::PolyScene& scene = import.scene;
  std::size_t faces = 0;
  std::size_t holes = 0;
  std::size_t edges = 0;
  scene::PolyPoint low = scene.vertices.at(0);
  scene::PolyPoint high = low;
  for (const scene::PolyBody& body : scene.bodies) {
    faces += body.faces.size();
    for (const scene::PolyFace& face : body.faces) holes += face.holes.size();
    const auto sides = scene::face_edges(body);
    for (std::size_t i = 0; i < sides.size(); ++i)
      edges += i == 0 || !sides[i].same_edge(sides[i - 1]) ? 1U : 0U;
  }
  for (const scene::PolyPoint& p : scene.vertices) {
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], p[a]);
      high[a] = std::max(high[a], p[a]);
    }
  }
  const auto& report = import.report;
  if (json) {
    const ordered_json document{{"schema", "sightline/scene-info/1"},
                                {"name", scene.name},
                                {"vertices", scene.vertices.size()},
                                {"edges", edges},
                                {"faces", faces},
                                {"holes", holes},
                                {"bodies", scene.bodies.size()},
                                {"sheets", report.sheets},
                                {"bounds", ordered_json::array({low, high})},
                                {"step", scene.step},
                                {"origin", scene.origin},
                                {"quantised", report.quantised},
                                {"largest_shift", report.largest_shift},
                                {"split_faces", report.split_faces},
                                {"largest_deviation", report.largest_deviation}};
    write_stdout(document.dump(2) + "\n");
    return;
  }
  tell(report);
  write_stdout(fmt::format("name           {}\n", scene.name));
  write_stdout(fmt::format("vertices       {}\nedges          {}\n", scene.vertices.size(), edges));
  write_stdout(fmt::format("faces          {}, with {} holes\n", faces, holes));
  write_stdout(fmt::format("bodies         {} solids, {} sheets\n", scene.bodies.size() - report.sheets,
                           report.sheets));
  write_stdout(fmt::format("bounds         x {}..{}  y {}..{}  z {}..{}\n", low[0], high[0], low[1], high[1],
                           low[2], high[2]));
  write_stdout(fmt::format("step           {}\n", scene.step));
  write_stdout(fmt::format("camera         {} at {},{},{}\n",
                           scene.camera.perspective ? "perspective" : "orthographic", scene.camera.eye[0],
                           scene.camera.eye[1], scene.camera.eye[2]));
}

void add_scene_convert(CLI::App& scene_command, ExitCode& exit_code) {
  CLI::App* const command = scene_command.add_subcommand("convert", "Read a scene and write it as polyhedra");
  const auto arguments = std::make_shared<ConvertArguments>();
  command->add_option("SCENE", arguments->scene, std::string(scene_source_help))->required();
  command->add_flag("--mend", arguments->mend,
                    "Of OFF and OBJ: repair what can be repaired without guessing");
  command
      ->add_option("-o,--output", arguments->output,
                   "A .json, .off or .obj file; - is JSON on standard output")
      ->capture_default_str()
      ->type_name("FILE");
  command->footer(convert_examples);
  command->callback([arguments, &exit_code] {
    convert(*arguments);
    exit_code = ExitCode::ok;
  });
}

}  // namespace sightline::app
