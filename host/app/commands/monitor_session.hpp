// The prompt of the monitor: lines of a person or a pipe, answered by live::Monitor.
#pragma once

#include <string>
#include <vector>

#include "host/app/command.hpp"
#include "host/machines/engine.hpp"
#include "host/live/monitor/monitor.hpp"
#include "host/live/symbols.hpp"

namespace sightline::app {

// The options of the monitor: those of `run` that make a machine, and its own.
[[nodiscard]] std::vector<machines::Option> monitor_options(const machines::MachineDescription& machine);

// --radix; 0: that of the machine.
[[nodiscard]] int radix_of(const machines::Arguments& arguments);

// --dialect; empty: that of the machine's assembler.
[[nodiscard]] std::string dialect_of(const machines::Arguments& arguments);

// Reads and writes the files that commands name. There is no console to have a speed.
[[nodiscard]] live::MonitorHost files_of_commands();

// A machine made with --monitor; sources among its programs are assembled in place.
struct MonitoredMachine {
  machines::Prepared prepared;
  live::Symbols symbols;
};
// Error usage, bad_input or io.
[[nodiscard]] MonitoredMachine make_monitored(const machines::MachineDescription& description,
                                              machines::Arguments arguments);

struct MonitorSetup {
  const machines::MachineDescription& description;
  machines::Machine& machine;  // made with --monitor
  machines::Limits limits;
  live::Symbols symbols;
  // --console and --speed say how the program's console runs, --do what to begin with.
  const machines::Arguments& arguments;
};

// Until `quit`, the end of the input, or a line that goes wrong in a pipe.
[[nodiscard]] ExitCode hold_monitor_session(MonitorSetup setup);

}  // namespace sightline::app
