// `sightline report` is a program of its own, `sightline-report`, which only those build who want the report.
#pragma once

#include "host/app/command.hpp"

namespace sightline::app {

// Lists the subcommand in the help. The program itself reads its options.
void add_report_command(CLI::App& app);

// Becomes the program `sightline-report`, with the same arguments: beside this program in a build folder,
// under libexec in an installation. Returns only if it is not there, and has said so.
[[nodiscard]] ExitCode run_report_program(char** argv);

}  // namespace sightline::app
