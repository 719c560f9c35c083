// `sightline run`: Any PDP-7 program on the emulated machine, with or without the display; and the command that holds
// the 8080's (run_i8080.hpp).
#pragma once

#include "host/app/command.hpp"

namespace sightline::app {

// `exit_code` is set when the subcommand has run; it outlives the App.
void add_run_command(CLI::App& app, ExitCode& exit_code);

}  // namespace sightline::app
