// `sightline asm i8080`: 8080 source to a .com, .bin or Intel HEX file, listing and symbols.
#pragma once

#include "host/app/command.hpp"

namespace sightline::app {

// `parent` is the command `asm`.
void add_asm_i8080_command(CLI::App& parent, ExitCode& exit_code);

}  // namespace sightline::app
