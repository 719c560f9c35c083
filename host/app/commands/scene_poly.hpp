// Scenes of every kind as text, general polyhedra from it, and the subcommand `sightline scene convert`.
#pragma once

#include <string>

#include "host/app/command_line.hpp"
#include "host/base/result.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/read/cell_complex_file.hpp"
#include "host/scene/read/poly_import.hpp"

namespace sightline::app {

enum class SceneKind {
  cells,         // of the PDP-7 program; all that is nothing else
  polyhedra,     // OFF or OBJ by its name or beginning, or JSON with bodies
  cell_complex,  // as `scene compartment` writes it
};

// SCENE, read once: it may be a pipe. A generated scene is the JSON that `scene generate` would write of it.
struct SceneText {
  std::string name;
  std::string text;
  bool builtin = false;
  SceneKind kind = SceneKind::cells;
};

// Failure io if SCENE is neither a built-in name nor that of a generated scene nor a file, or cannot be read;
// usage: a generated scene of an impossible size.
[[nodiscard]] SceneText read_scene_text(const std::string& name_or_file);

[[nodiscard]] base::Result<scene::PolyImport> read_poly_text(const SceneText& file, bool mend);
// Of a file of polyhedra, read and checked. Failure bad_input, naming the first thing that is wrong.
[[nodiscard]] scene::PolyImport load_poly_file(const SceneText& file, bool mend);
// What was done to the scene while it was read, as warnings.
void tell(const scene::PolyImportReport& report);

// Read and checked. Failure bad_input, likewise.
[[nodiscard]] scene::CellComplexFile load_cell_complex(const SceneText& file);

// As the file's name says, JSON to standard output (-). `source`: what the scene came from, for an error in
// it.
void write_scene(const scene::PolyScene& scene, const std::string& source, const std::string& path);

// `scene convert`. `exit_code` is set when the subcommand has run; it outlives the App.
void add_scene_convert(const Command& scene_command);

}  // namespace sightline::app
