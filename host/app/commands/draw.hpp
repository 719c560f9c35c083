// `sightline draw ALGORITHM SCENE -o FILE`: today's use of the algorithms, without a machine of their time.
#pragma once

#include "host/app/command.hpp"

namespace sightline::app {

// `exit_code` is set when a subcommand has run; it outlives the App.
void add_draw_command(CLI::App& app, ExitCode& exit_code);

}  // namespace sightline::app
