// --eae and --no-eae: whether the PDP-7 has the Type 177 extended arithmetic element. The same two flags in
// every subcommand that runs a PDP-7; the first is the default and there to be said.
#pragma once

#include "host/app/command_line.hpp"

namespace sightline::app {

void add_eae_options(const Command& command, bool& no_eae);
void add_eae_options(CLI::App& command, bool& no_eae);

}  // namespace sightline::app
