#include "host/app/scene_argument.hpp"

#include <fmt/core.h>

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "host/base/number.hpp"
#include "host/base/threads.hpp"
#include "host/hidden_lines/hidden_lines.hpp"

namespace sightline::app {

namespace {

constexpr const char* cells_expected =
    "expected a scene of cells, the input of Jones's program; `sightline draw jones` takes all scenes";

void remove_wires(scene::LoadedScene& loaded) {
  const std::size_t count = loaded.scene.wires.size();
  const std::string found = fmt::format("{} {} without faces", count, count == 1 ? "line" : "lines");
  if (loaded.scene.bodies.empty()) {
    throw base::bad_input(fmt::format("{}: found only {}, expected a scene with faces; `sightline draw exact` draws {}",
                                                   loaded.name, found, count == 1 ? "it" : "them"));
  }
  warn(fmt::format("{}: {} left out; `sightline draw exact` draws {}", loaded.name, found, count == 1 ? "it" : "them"));
  loaded.scene = scene::without_wires(std::move(loaded.scene));
}

}  // namespace

scene::SceneFile find_scene(const std::string& argument) {
  if (argument == "-") return {.name = display_name(argument), .text = read_input_text(argument)};
  return value_of(hidden_lines::find(argument));
}

scene::LoadedScene load_found(scene::SceneFile file, const scene::PolyImportOptions& options) {
  return value_of(hidden_lines::load(std::move(file), options));
}

scene::PolyImportOptions MeshArguments::import_options() const {
  require_finite("--weld", weld);
  if (planar_tolerance) require_finite("--planar-tolerance", *planar_tolerance);
  return {.mend = !strict, .weld = weld, .planar_tolerance = planar_tolerance, .eye = eye, .folder = {}, .unit = unit, .jobs = base::useful_threads(jobs)};
}

void add_mesh_options(const Command& command, MeshArguments& arguments) {
  const Option strict =
      command.flag("--strict", arguments.strict, "Repair nothing: any defect of a mesh is an error").group("Mesh");
  command.option("--weld", arguments.weld, "Merge vertices at most this far apart, in the unit of the file")
      .range(0.0, 1e30)
      .default_value("only vertices at the same point")
      .value("DISTANCE")
      .excludes(strict)
      .group("Mesh");
  command
      .option("--planar-tolerance", arguments.planar_tolerance,
              "Faces within this distance of the plane of a larger face are merged with it")
      .range(0.0, 1e30)
      .default_value("4 units of the precision of the file, at most a thousandth of its size")
      .value("DISTANCE")
      .excludes(strict)
      .group("Mesh");
  command.option("--unit", arguments.unit, "The unit of the coordinates, if the file does not specify it")
      .one_of({"um", "mm", "cm", "m", "inch", "ft"})
      .default_value("as specified in 3MF, m for glTF, none for others")
      .group("Mesh");
}

void warn_of_units(const scene::LoadedScene& loaded, const MeshArguments& mesh) {
  if (mesh.unit.empty() || loaded.report.unit == mesh.unit) return;
  warn(loaded.report.unit.empty() ? fmt::format("--unit: {} is no mesh, and its coordinates have no unit", loaded.name)
                                  : fmt::format("--unit is ignored: {} specifies {} as the unit of its coordinates",
                                                loaded.name, loaded.report.unit));
}

scene::LoadedScene load_scene(const std::string& argument, const MeshArguments& mesh, Wires wires) {
  return load_scene(find_scene(argument), argument, mesh, wires);
}

scene::LoadedScene load_scene(scene::SceneFile file, const std::string& argument, const MeshArguments& mesh, Wires wires) {
  scene::LoadedScene loaded = load_found(std::move(file), mesh.import_options());
  warn_of_changes(loaded.report);
  warn_of_units(loaded, mesh);
  loaded.name = argument;
  if (wires == Wires::remove && !loaded.scene.wires.empty()) remove_wires(loaded);
  return loaded;
}

scene::CellScene load_cells(const std::string& argument) {
  scene::SceneFile file = find_scene(argument);
  if (file.generated) {
    throw base::usage_error(fmt::format("{}: found the name of a generated scene, {}", argument, cells_expected));
  }
  const std::string name = file.name;
  scene::SceneReading reading = scene::read_scene(std::move(file));
  if (reading.loaded.kind != scene::SceneKind::cells)
    throw base::bad_input(fmt::format("{}: found polyhedra, {}", name, cells_expected));
  return *value_of(scene::scene_or_error(std::move(reading)), name).cells;
}

void add_go_on_option(const Command& command, bool& go_on) {
  command.flag("--go-on", go_on, "Draw even if this method takes more than a minute").group("Mesh");
}

void reject_long_work(const scene::LoadedScene& mesh, std::string_view method, const registry::MeshTime& time,
                      bool go_on) {
  if (go_on || mesh.scene.surfaces.empty()) return;
  constexpr double longest = 60;
  const double seconds = time.seconds_for(mesh.scene);
  if (seconds < longest) return;
  throw base::usage_error(fmt::format("{}: {} is {} here, and takes about {:.0f} minutes for {} faces{}; "
                            "`sightline draw exact` takes seconds; --go-on draws it anyway",
                            mesh.name, method, time.by_planes ? "slow" : "quadratic", std::ceil(seconds / 60), scene::face_count(mesh.scene),
                            time.by_planes ? ", which cross each other's planes" : ""));
}

void add_eae_options(const Command& command, bool& no_eae) {
  const Option with =
      command.flag("--eae", "The PDP-7 with the Type 177 extended arithmetic element, the default");
  command.flag("--no-eae", no_eae, "The PDP-7 without it, where 64xxxx does nothing").excludes(with);
}

void warn_of_changes(const scene::PolyImportReport& report) {
  for (const std::string& note : hidden_lines::notes_of(report)) warn(note);
  const scene::MendReport& faces = report.faces;
  if (faces.helpful_weld > 0) {
    warn(fmt::format("{} {} open; --weld {} {}", faces.sheets, faces.sheets == 1 ? "part is" : "parts are",
                     faces.helpful_weld,
                     faces.sheets_with_weld > 0 ? fmt::format("leaves {}", faces.sheets_with_weld)
                                                : fmt::format("closes {}", faces.sheets == 1 ? "it" : "them")));
  }
}

geometry::Point point_argument(std::string_view option, std::string_view text) {
  constexpr std::int32_t most = 32767;
  if (const auto point = base::whole_numbers<std::int32_t, 3>(text, ',', -most, most)) return *point;
  throw base::usage_error(fmt::format("{}: found \"{}\", expected X,Y,Z, three whole numbers from -32767 to 32767",
                            option, text));
}

}  // namespace sightline::app
