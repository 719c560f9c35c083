// `sightline asm`: Symbolic source to a tape, a core image, a listing and a table of symbols.
#pragma once

#include "host/app/command.hpp"

namespace sightline::app {

// `exit_code` is set when the subcommand has run; it outlives the App.
void add_asm_command(CLI::App& app, ExitCode& exit_code);

}  // namespace sightline::app
