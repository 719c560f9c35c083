// `sightline scene generate`: scenes of random families.
#pragma once

#include "host/app/command.hpp"

namespace sightline::app {

// `exit_code` is set when the subcommand has run; it outlives the App.
void add_scene_generate(CLI::App& scene_command, ExitCode& exit_code);

}  // namespace sightline::app
