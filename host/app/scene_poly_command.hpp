// `sightline scene` for general polyhedra: what check and info say of them, and the subcommand convert.
#pragma once

#include <string>

#include "host/app/command.hpp"
#include "host/scene/poly_import.hpp"

namespace sightline::app {

// SCENE, read once: it may be a pipe. A generated scene is the JSON that `scene generate` would write of it.
struct SceneText {
  std::string name;
  std::string text;
  bool builtin = false;
  bool polyhedra = false;  // the name ends in .off or .obj, or it is JSON with bodies; not if built in
};

// Failure io if SCENE is neither a built-in name nor that of a generated scene nor a file, or cannot be read;
// usage: a generated scene of an impossible size.
[[nodiscard]] SceneText read_scene_text(const std::string& name_or_file);

// Of a file of polyhedra, read and checked. Failure bad_input, naming the first thing that is wrong.
[[nodiscard]] scene::PolyImport load_poly_file(const SceneText& file, bool mend);
// What was done to the scene while it was read, as warnings.
void tell(const scene::PolyImportReport& report);

// What `scene check` and `scene info` do with polyhedra.
[[nodiscard]] ExitCode check_poly_file(const SceneText& file, bool json);
void describe_poly_file(const SceneText& file, bool json);

// As the file's name says, JSON to standard output (-). `source`: what the scene came from, for an error in it.
void write_scene(const scene::PolyScene& scene, const std::string& source, const std::string& path);

// `scene convert`. `exit_code` is set when the subcommand has run; it outlives the App.
void add_scene_convert(CLI::App& scene_command, ExitCode& exit_code);

}  // namespace sightline::app
