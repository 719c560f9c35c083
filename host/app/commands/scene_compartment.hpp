// `sightline scene compartment`: free space of a scene cut into convex cells and openings.
#pragma once

#include "host/app/command_line.hpp"

namespace sightline::app {

// `exit_code` is set when the subcommand has run; it outlives the App.
void add_scene_compartment_command(const Command& scene_command);

}  // namespace sightline::app
