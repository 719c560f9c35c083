// The prompt of the monitor: reads lines from a person or a pipe and passes them to live::Monitor.
#pragma once

#include <string>
#include <vector>

#include "host/app/command.hpp"
#include "host/machines/engine.hpp"
#include "host/live/monitor/monitor.hpp"
#include "host/live/symbols.hpp"

namespace sightline::app {

// The options of `monitor`: those of `run` that configure a machine, and its own.
[[nodiscard]] std::vector<machines::Option> monitor_options(const machines::MachineDescription& machine);

// The value of --radix; 0: the radix of the machine.
[[nodiscard]] int radix_of(const machines::Arguments& arguments);

// The value of --dialect; empty: that of the machine's assembler.
[[nodiscard]] std::string dialect_of(const machines::Arguments& arguments);

// A host that reads and writes the files that commands name. It has no console.
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
  // --console and --speed configure the program's console; --do names the first commands.
  const machines::Arguments& arguments;
};

// Runs until `quit`, the end of the input, or, if the input is a pipe, the first error.
[[nodiscard]] ExitCode run_monitor_session(MonitorSetup setup);

}  // namespace sightline::app
