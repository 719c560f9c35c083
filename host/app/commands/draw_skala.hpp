// `sightline draw skala`: a surface over a grid with its hidden parts removed.
#pragma once

#include "host/app/command_line.hpp"

namespace sightline::app {

void add_draw_skala(const Command& command);

}  // namespace sightline::app
