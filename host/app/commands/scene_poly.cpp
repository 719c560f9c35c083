// See scene_poly.hpp.
#include "host/app/commands/scene_poly.hpp"

#include <fmt/format.h>

#include <memory>
#include <string>
#include <utility>

#include "host/app/scene_argument.hpp"
#include "host/app/scene_source.hpp"
#include "host/base/result.hpp"
#include "host/scene/check/poly_scene.hpp"
#include "host/scene/model/poly_from_cells.hpp"
#include "host/scene/read/builtin.hpp"
#include "host/scene/read/poly_file.hpp"
#include "host/scene/read/poly_json.hpp"

namespace sightline::app {

namespace {

scene::PolyFormat input_format(const SceneText& file) {
  return scene::poly_format_of(file.name, file.text);
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
  if (arguments.mend && (file.builtin || input_format(file) == scene::PolyFormat::json)) {
    throw Failure(ExitCode::usage, fmt::format("--mend: found {}, expected an OFF or OBJ file", file.name));
  }
  if (file.kind == SceneKind::polyhedra) {
    const scene::PolyImport import = load_poly_file(file, arguments.mend);
    tell(import.report);
    write_scene(import.scene, file.name, arguments.output);
  } else {
    const bool cut = file.kind == SceneKind::cell_complex;
    write_scene(cut ? load_cell_complex(file).scene : scene::poly_scene_of(load_scene(file.text, file.name)),
                file.name, arguments.output);
  }
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
  if (!text) {
    text.error().file = source;
    throw Failure(ExitCode::bad_input, text.error().message());
  }
  Output output(path);
  output.write(*text);
  output.commit();
}

void tell(const scene::PolyImportReport& report) {
  if (report.quantised && report.largest_shift > 0) {
    warn(
        fmt::format("coordinates rounded to a step of {}, by at most {}", report.step, report.largest_shift));
  } else if (report.quantised) {
    warn(fmt::format("coordinates are counted in steps of {}", report.step));
  }
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

base::Result<scene::PolyImport> read_poly_text(const SceneText& file, bool mend) {
  return scene::read_poly(file.text, file.name, input_format(file), {mend});
}

scene::PolyImport load_poly_file(const SceneText& file, bool mend) {
  auto read = read_poly_text(file, mend);
  if (!read) throw Failure(ExitCode::bad_input, read.error().message());
  auto import = std::move(*read);
  auto errors = scene::check_poly_scene(import.scene);
  if (!errors.empty()) {
    errors.front().file = file.name;
    const std::string more =
        errors.size() > 1 ? fmt::format(" (the first of {} errors)", errors.size()) : std::string();
    throw Failure(ExitCode::bad_input, errors.front().message() + more);
  }
  return import;
}

scene::CellComplexFile load_cell_complex(const SceneText& file) {
  auto read = scene::read_cell_complex(file.text, file.name);
  if (!read) throw Failure(ExitCode::bad_input, read.error().message());
  return std::move(*read);
}

SceneText read_scene_text(const std::string& name_or_file) {
  if (const auto generated = generated_scene(name_or_file)) {
    auto text = scene::write_poly(*generated, scene::PolyFormat::json);
    return {name_or_file, std::move(*text), false, SceneKind::polyhedra};
  }
  if (name_or_file != "-") require_scene_exists(name_or_file);
  if (const auto builtin = scene::builtin_scene_text(name_or_file))
    return {name_or_file, std::string(*builtin), true, SceneKind::cells};
  SceneText file{shown_name(name_or_file), read_input_text(name_or_file), false, SceneKind::cells};
  if (scene::is_cell_complex(file.text))
    file.kind = SceneKind::cell_complex;
  else if (input_format(file) != scene::PolyFormat::json || scene::is_poly_json(file.text))
    file.kind = SceneKind::polyhedra;
  return file;
}

void add_scene_convert(const Command& scene_command) {
  const Command command = scene_command.add_command("convert", "Read a scene and write it as polyhedra");
  const auto arguments = std::make_shared<ConvertArguments>();
  command.option("SCENE", arguments->scene, scene_source_help).required();
  command.flag("--mend", arguments->mend, "Of OFF and OBJ: repair what can be repaired without guessing");
  command.option("-o,--output", arguments->output, "A .json, .off or .obj file; - is JSON on standard output")
      .default_value()
      .value("FILE");
  command.footer(convert_examples);
  command.run([arguments] {
    convert(*arguments);
    return ExitCode::ok;
  });
}

}  // namespace sightline::app
