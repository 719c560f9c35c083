// The SCENE argument, the same in every command that has one: built in, generated, a file of any kind, or
// standard input.
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
// Of commands that run Jones's program.
inline constexpr std::string_view cells_help =
    "A built-in scene (see `sightline scene list`) or a JSON file of a scene of cells";

// What a mesh has wrong is mended, unless --strict is given, and said in one line.
struct MeshArguments {
  bool strict = false;
  double weld = 0;
  std::optional<double> planar_tolerance = {};
  std::string unit;  // empty: not given
  std::optional<std::array<double, 3>> eye = {};  // see CameraArguments

  [[nodiscard]] scene::PolyImportOptions import_options() const;
};
void add_mesh_options(const Command& command, MeshArguments& arguments);

// Its text, or the generated scene. Error io: no such scene or file, or it cannot be read; usage: a
// generated scene of an impossible size.
[[nodiscard]] scene::SceneFile find_scene(const std::string& argument);

// Read and checked. Error bad_input: the first thing that is wrong.
[[nodiscard]] scene::LoadedScene load_found(scene::SceneFile file,
                                            const scene::PolyImportOptions& options = {});

// Whether lines without faces (PolyScene::wires) are kept, or left out with a warning.
enum class Wires { left_out, kept };

// Found, read and checked; named as the argument is. What was changed while reading is said on standard
// error. Error as find_scene, or bad_input: the first thing that is wrong, or nothing but wires to leave out.
[[nodiscard]] scene::LoadedScene load_scene(const std::string& argument, const MeshArguments& mesh = {},
                                            Wires wires = Wires::left_out);
// The same; anything but a scene of cells is an error of usage or bad_input.
[[nodiscard]] scene::CellScene load_cells(const std::string& argument);

// --go-on: of a command that draws by one method.
void add_go_on_option(const Command& command, bool& go_on);
// Error usage: the method would take more than a minute for so many faces of a mesh, and --go-on is not given.
void refuse_long_work(const scene::LoadedScene& mesh, std::string_view method, const registry::MeshTime& time, bool go_on);

// --eae and --no-eae, of commands that run Jones's program: whether the PDP-7 has the Type 177 extended
// arithmetic element. The first is the default.
void add_eae_options(const Command& command, bool& no_eae);

// A warning if --unit was given for a scene that has its own, or that is no mesh.
void warn_of_units(const scene::LoadedScene& loaded, const MeshArguments& mesh);

// What was done to the scene while it was read, as warnings.
void warn_of_changes(const scene::PolyImportReport& report);

// "X,Y,Z", decimal integers below 2^15 in magnitude. Error usage.
[[nodiscard]] geometry::Point point_argument(std::string_view option, std::string_view text);

}  // namespace sightline::app
