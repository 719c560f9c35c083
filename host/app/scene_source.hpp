// The SCENE of the commands that draw by native algorithms: built in, from a file of any kind, or generated.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "host/scene/model/cell_complex.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::app {

inline constexpr std::string_view scene_source_help =
    "A built-in scene (see `sightline scene list`), a JSON, OFF or OBJ file (- for standard input), or "
    "FAMILY-SIZE or FAMILY-SIZE-SEED of a generated one, such as boxes-100 (see `sightline scene generate "
    "--help`)";

struct SceneSource {
  std::string name;                           // as it was asked for
  std::optional<scene::CellScene> cells;      // of a scene made of cells
  scene::PolyScene scene;                     // checked
  std::optional<scene::CellComplex> complex;  // of a file `scene compartment` has written; checked
};

// The scene of a name such as "boxes-100" or "boxes-100-7"; nothing for another name, or if there is a file
// of it. Failure usage: of an impossible size.
[[nodiscard]] std::optional<scene::PolyScene> generated_scene(const std::string& name);

// Failure io: no such scene or file; usage: a generated one of an impossible size; bad_input: what is wrong
// with the file. What was changed while reading is said on standard error.
[[nodiscard]] SceneSource load_scene_source(const std::string& name);

}  // namespace sightline::app
