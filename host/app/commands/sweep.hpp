// `sightline sweep`: many random views of a scene, held against each other.
#pragma once

#include "host/app/command.hpp"

namespace sightline::app {

// `exit_code` is set when the subcommand has run; it outlives the App.
void add_sweep_command(CLI::App& app, ExitCode& exit_code);

}  // namespace sightline::app
