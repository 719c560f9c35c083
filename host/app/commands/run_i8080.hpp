// `sightline run i8080`: Any 8080 program on the emulated machine, CP/M programs too, with the devices it
// asks for.
#pragma once

#include "host/app/command.hpp"

namespace sightline::app {

// `parent` is the command `run`; `exit_code` is set when the subcommand has run.
void add_run_i8080_command(CLI::App& parent, ExitCode& exit_code);

}  // namespace sightline::app
