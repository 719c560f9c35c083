// `sightline demo`: both machines, Jones's program on all scenes and Skala's on the eight functions.
#pragma once

#include "host/app/command.hpp"

namespace sightline::app {

// `exit_code` is set when the subcommand has run; it outlives the App.
void add_demo_command(CLI::App& app, ExitCode& exit_code);

}  // namespace sightline::app
