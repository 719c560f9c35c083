// The frame of a program with subcommands: reads the command line, prints help, version and what a subcommand
// fails with, and gives the exit code of the process.
//
// Exit codes are this program's own (command.hpp), not those of the command-line library.
#pragma once

#include <functional>
#include <string>

#include "host/app/command.hpp"

namespace sightline::app {

// `add_commands` adds the subcommands; each sets the exit code when it has run. `footer` ends the help of the
// program.
[[nodiscard]] int run_command_line(int argc, char** argv, const std::string& footer,
                                   const std::function<void(CLI::App&, ExitCode&)>& add_commands);

}  // namespace sightline::app
