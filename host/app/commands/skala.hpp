// `sightline skala`: Skala's hidden lines, shaded surfaces and contours on the 8080.
#pragma once

#include "host/app/command.hpp"

namespace sightline::app {

// `exit_code` is set when a subcommand has run; it outlives the App.
void add_skala_command(CLI::App& app, ExitCode& exit_code);

}  // namespace sightline::app
