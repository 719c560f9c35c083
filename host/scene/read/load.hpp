// Loads the scene that a user names: built in, generated, or the text of a file of any kind.
//
// Two steps. named_scene resolves a name without reading a file; the text of a file or of
// standard input comes from the caller, who knows how to fail. read_scene or load_scene then makes a scene of
// it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/cells/decompose.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"
#include "host/scene/read/poly_import.hpp"

namespace sightline::scene {

// What a scene is read from: a text, or a generated scene, which has none.
struct SceneFile {
  std::string name;  // named in errors; its ending tells the format
  std::string text = {};
  std::string folder = {};  // in which the file is; empty: it came from standard input
  bool builtin = false;
  std::optional<PolyScene> generated = {};
};

// A built-in scene, or a generated one: FAMILY-SIZE or FAMILY-SIZE-SEED, such as boxes-100-7, if no file has
// that name. Empty if the name is neither. An error for a generated scene of an impossible size.
[[nodiscard]] std::optional<base::Result<SceneFile>> named_scene(const std::string& name);

enum class SceneKind {
  cells,         // of the PDP-7 program; a text that is nothing else
  polyhedra,     // a mesh by its beginning or name, JSON with bodies, or generated
  cell_complex,  // a cell decomposition: JSON that names its schema
};
// Meshes have damage that can be mended; JSON, built-in and generated scenes are taken as they are.
[[nodiscard]] bool can_be_mended(const SceneFile& file);

struct LoadedScene {
  std::string name;
  SceneKind kind = SceneKind::polyhedra;
  PolyScene scene = {};                             // of every kind
  std::optional<CellScene> cells = {};              // of kind cells
  std::optional<Decomposition> decomposition = {};  // of kind cell_complex
  PolyImportReport report = {};                     // of kind polyhedra: what was changed while reading
};

// The cells that the scene came with, of the kinds cells and cell_complex; empty for polyhedra.
[[nodiscard]] std::optional<CellComplex> own_cells(const LoadedScene& loaded);

struct SceneReading {
  // Complete if there are no errors; the name and the kind are known always, and of a mesh what mending makes of it.
  LoadedScene loaded;
  std::vector<base::Error>
      errors;  // all that a check names: see check_scene, check_poly_scene, check_complex
};
// Read and checked, without a byte-order mark of UTF-8. The cameras of scenes are not checked: see eye_error.
[[nodiscard]] SceneReading read_scene(SceneFile file, const PolyImportOptions& options = {});

// The scene, or the first of the errors, which says how many there are.
[[nodiscard]] base::Result<LoadedScene> scene_or_error(SceneReading reading);

// Both steps; generated scenes are not checked again.
[[nodiscard]] base::Result<LoadedScene> load_scene(SceneFile file, const PolyImportOptions& options = {});

}  // namespace sightline::scene
