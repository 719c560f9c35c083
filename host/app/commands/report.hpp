// `sightline report`: the measurements and comparisons of both machines as one page, with its tables beside
// it.
#pragma once

#include "host/app/command.hpp"

namespace sightline::app {

// `exit_code` is set when the subcommand has run; it outlives the App.
void add_report_command(CLI::App& app, ExitCode& exit_code);

}  // namespace sightline::app
