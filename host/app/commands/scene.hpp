// `sightline scene`: Scenes: check them, describe them, and write them as the source tape of the PDP-7
// program.
#pragma once

#include "host/app/command.hpp"

namespace sightline::app {

// `exit_code` is set when the subcommand has run; it outlives the App.
void add_scene_command(CLI::App& app, ExitCode& exit_code);

}  // namespace sightline::app
