// `sightline scene generate`: scenes of random families.
#pragma once

#include "host/app/command_line.hpp"

namespace sightline::app {

// `exit_code` is set when the subcommand has run; it outlives the App.
void add_scene_generate(const Command& scene_command);

}  // namespace sightline::app
