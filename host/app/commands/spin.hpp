// `sightline spin`: a scene turning about its vertical axis, hidden lines removed, as an animated PNG, after
// Plantinga, Seales and Dyer (1990).
#pragma once

#include "host/app/command.hpp"

namespace sightline::app {

void add_spin_command(CLI::App& app, ExitCode& exit_code);

}  // namespace sightline::app
