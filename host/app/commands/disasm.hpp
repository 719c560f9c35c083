// `sightline disasm`: A tape or a core image back to symbolic source.
#pragma once

#include "host/app/command.hpp"

namespace sightline::app {

// `exit_code` is set when the subcommand has run; it outlives the App.
void add_disasm_command(CLI::App& app, ExitCode& exit_code);

}  // namespace sightline::app
