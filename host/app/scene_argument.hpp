// The SCENE argument, the same in every command that has one: a built-in or generated scene, a file of any kind, or standard
// input.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "host/algorithms/registry/mesh_time.hpp"
#include "host/app/command_line.hpp"
#include "host/geometry/box.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/read/load.hpp"

namespace sightline::app {

inline constexpr std::string_view scene_help =
    "A built-in scene (see `sightline scene list`), a JSON, OFF, OBJ, STL, PLY, glTF or 3MF file (- for standard input), "
    "or FAMILY-SIZE or FAMILY-SIZE-SEED of a generated one, such as boxes-100 (see `sightline scene generate "
    "--help`)";
// For commands that run Jones's program.
inline constexpr std::string_view cells_help =
    "A built-in scene (see `sightline scene list`) or a JSON file of a scene of cells";

// Options for reading meshes. Defects of a mesh are repaired and reported in one line; with --strict they are errors.
struct MeshArguments {
  bool strict = false;
  double weld = 0;
  std::optional<double> planar_tolerance = {};
  std::string unit;  // empty: not given
  std::optional<std::array<double, 3>> eye = {};  // see CameraArguments
  unsigned jobs = 1;  // threads: no mesh option

  [[nodiscard]] scene::PolyImportOptions import_options() const;
};
void add_mesh_options(const Command& command, MeshArguments& arguments);

// Finds a scene by its argument and returns the text of its file, or the generated scene. Error io: no such scene or file, or
// it cannot be read; usage: a generated scene of an impossible size.
[[nodiscard]] scene::SceneFile find_scene(const std::string& argument);

// Parses and checks a scene. Error bad_input: the first defect.
[[nodiscard]] scene::LoadedScene load_found(scene::SceneFile file,
                                            const scene::PolyImportOptions& options = {});

// Whether lines without faces (PolyScene::wires) are kept, or removed with a warning.
enum class Wires { remove, keep };

// Finds, parses and checks a scene; its name is the argument. Repairs are reported on standard error. Errors as find_scene, or
// bad_input: the first defect, or a scene that consists of wires only and wires are removed.
[[nodiscard]] scene::LoadedScene load_scene(const std::string& argument, const MeshArguments& mesh = {},
                                            Wires wires = Wires::remove);
// The same for a scene that was found.
[[nodiscard]] scene::LoadedScene load_scene(scene::SceneFile file, const std::string& argument, const MeshArguments& mesh,
                                            Wires wires = Wires::remove);
// The same for scenes of cells; any other scene is an error of usage or bad_input.
[[nodiscard]] scene::CellScene load_cells(const std::string& argument);

// --go-on, for commands that draw by one method.
void add_go_on_option(const Command& command, bool& go_on);
// Error usage: the method would take more than a minute for this mesh, and --go-on is not given.
void reject_long_work(const scene::LoadedScene& mesh, std::string_view method, const registry::MeshTime& time, bool go_on);

// --eae (the default) and --no-eae, for commands that run Jones's program: whether the PDP-7 has the Type 177 extended
// arithmetic element.
void add_eae_options(const Command& command, bool& no_eae);

// Warns if --unit was given for a scene that has its own unit or is no mesh.
void warn_of_units(const scene::LoadedScene& loaded, const MeshArguments& mesh);

// Warns of everything that was changed in the scene while it was read.
void warn_of_changes(const scene::PolyImportReport& report);

// "X,Y,Z", decimal integers below 2^15 in magnitude. Error usage.
[[nodiscard]] geometry::Point point_argument(std::string_view option, std::string_view text);

}  // namespace sightline::app
