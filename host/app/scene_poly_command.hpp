// `sightline scene` for general polyhedra: what check and info say of them, and the subcommands convert and
// generate.
#pragma once

#include <string>

#include "host/app/command.hpp"

namespace sightline::app {

// A file whose name ends in .off or .obj, or a JSON file with bodies; false for a built-in name. Failure io
// if it is neither a built-in name nor a file, or cannot be read.
[[nodiscard]] bool is_poly_scene(const std::string& name_or_file);

// What `scene check` and `scene info` do with it.
[[nodiscard]] ExitCode check_poly_file(const std::string& file, bool json);
void describe_poly_file(const std::string& file, bool json);

// `scene convert` and `scene generate`. `exit_code` is set when the subcommand has run; it outlives the App.
void add_scene_poly_commands(CLI::App& scene_command, ExitCode& exit_code);

}  // namespace sightline::app
