// The programs of a command line that runs a machine: sources among them are assembled in place.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>

#include "host/machines/engine.hpp"
#include "host/live/symbols.hpp"

namespace sightline::app {

// The sources of a command line, assembled, and the symbols of all.
struct Programs {
  std::map<std::string, base::Bytes> assembled;  // under the names that --load has for them now
  live::Symbols symbols;

  // Reads what is assembled from here, and all else as a file. The programs outlive it.
  [[nodiscard]] machines::FileReader reader() const;
};

// The assembler's option of which language sources are in; null if it reads one.
[[nodiscard]] const machines::Option* dialect_option(const machines::MachineDescription& machine);

// Says on standard error if sources with errors are those of another machine: if its assembler finds none in them. `command`: that
// which was given ("run"); `names`: the files as they were given.
void say_whose_source(const machines::MachineDescription& machine, std::span<const assembler::SourceFile> sources,
                      std::string_view command, std::span<const std::string> names);

// Replaces sources in --load by what they assemble to; sources side by side are one program. Diagnostics go to standard error.
// `command`: that which was given. Error bad_input or io.
[[nodiscard]] Programs assemble_sources(const machines::MachineDescription& machine, machines::Arguments& arguments,
                                        std::string_view command);

}  // namespace sightline::app
