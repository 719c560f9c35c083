// `sightline draw skala`: a surface over a grid with its hidden parts removed.
#pragma once

#include "host/app/command.hpp"

namespace sightline::app {

void add_draw_skala(CLI::App& command, ExitCode& exit_code);

}  // namespace sightline::app
