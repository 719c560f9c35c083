// The programs of a command line that runs a machine: sources among them are assembled in place.
#pragma once

#include <map>
#include <string>

#include "host/guests/run/engine.hpp"
#include "host/live/symbols.hpp"

namespace sightline::app {

// The sources of a command line, assembled, and the symbols of all.
struct Programs {
  std::map<std::string, base::Bytes> assembled;  // under the names that --load has for them now
  live::Symbols symbols;

  // Reads what is assembled from here, and all else as a file. The programs outlive it.
  [[nodiscard]] guests::run::FileReader reader() const;
};

// The assembler's option of which language sources are in; null if it reads one.
[[nodiscard]] const guests::run::Option* dialect_option(const guests::run::MachineDescription& machine);

// Replaces sources in --load by what they assemble to; sources side by side are one program. Diagnostics go to standard error.
// Failure bad_input or io.
[[nodiscard]] Programs assemble_sources(const guests::run::MachineDescription& machine, guests::run::Arguments& arguments);

}  // namespace sightline::app
