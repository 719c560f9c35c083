// Assembles the sources among the programs of a command line that runs a machine.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>

#include "host/machines/engine.hpp"
#include "host/live/symbols.hpp"

namespace sightline::app {

// The assembled sources of a command line, and the symbols of all.
struct Programs {
  std::map<std::string, base::Bytes> assembled;  // by the names that --load now has for them
  live::Symbols symbols;

  // Reads assembled programs from here and everything else from files. The Programs must outlive the reader.
  [[nodiscard]] machines::FileReader reader() const;
};

// The assembler's option that selects the language of sources; null if it reads only one.
[[nodiscard]] const machines::Option* dialect_option(const machines::MachineDescription& machine);

// If the assembler of another machine accepts sources that have errors, prints a hint on standard error. `command`: the command that
// was given ("run"); `names`: the files as given.
void suggest_other_machine(const machines::MachineDescription& machine, std::span<const assembler::SourceFile> sources,
                      std::string_view command, std::span<const std::string> names);

// Replaces the sources in --load by assembled programs; adjacent sources are one program. Diagnostics go to standard error.
// `command`: the command that was given. Error bad_input or io.
[[nodiscard]] Programs assemble_sources(const machines::MachineDescription& machine, machines::Arguments& arguments,
                                        std::string_view command);

}  // namespace sightline::app
