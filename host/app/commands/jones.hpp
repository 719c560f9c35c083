// `sightline jones`: Jones's program on one scene.
#pragma once

#include "host/app/command.hpp"

namespace sightline::app {

// `exit_code` is set when the subcommand has run; it outlives the App.
void add_jones_command(CLI::App& app, ExitCode& exit_code);

}  // namespace sightline::app
