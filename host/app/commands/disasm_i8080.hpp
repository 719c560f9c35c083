// `sightline disasm i8080`: a .com, raw or Intel HEX file as 8080 source.
#pragma once

#include "host/app/command.hpp"

namespace sightline::app {

// `parent` is the command `disasm`.
void add_disasm_i8080_command(CLI::App& parent, ExitCode& exit_code);

}  // namespace sightline::app
