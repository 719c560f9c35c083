// `sightline compare`: one view by guest, twin, native algorithms and oracle, and where they differ.
#pragma once

#include "host/app/command.hpp"

namespace sightline::app {

// `exit_code` is set when the subcommand has run; it outlives the App.
void add_compare_command(CLI::App& app, ExitCode& exit_code);

}  // namespace sightline::app
