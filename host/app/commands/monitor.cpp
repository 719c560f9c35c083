// `sightline monitor`: examines and runs a machine, by commands at a prompt or from a file.
#include <fmt/core.h>

#include <string>
#include <utility>
#include <vector>

#include "host/app/commands/commands.hpp"
#include "host/app/commands/machine_command.hpp"
#include "host/app/commands/monitor_session.hpp"
#include "host/app/commands/program_sources.hpp"
#include "host/live/symbols.hpp"

namespace sightline::app {

namespace {

using machines::Arguments;
using machines::Machine;
using machines::MachineDescription;
using machines::OptionKind;

ExitCode monitor(const MachineDescription& description, const Arguments& arguments) {
  if (arguments.list("--load").empty() && !arguments.given("--restore")) {
    throw base::usage_error(fmt::format("monitor {}: needs a PROGRAM or --load FILE: without a program there is nothing to examine",
                                               description.name));
  }
  MonitoredMachine made = make_monitored(description, arguments);
  for (const std::string& warning : made.prepared.warnings) warn(warning);
  Machine& machine = *made.prepared.machine;
  const ExitCode code = run_monitor_session({description, machine, made.prepared.limits, std::move(made.symbols), arguments});
  write_media_back(machine);
  return code;
}

}  // namespace

MonitoredMachine make_monitored(const MachineDescription& description, Arguments arguments) {
  arguments.value("--monitor").flag = true;
  check_disk(arguments);
  Programs programs = assemble_sources(description, arguments, "monitor");
  for (const std::string& path : arguments.list("--symbols"))
    static_cast<void>(value_of(programs.symbols.add_table(read_input_text(path)), path));
  for (const std::string& path : arguments.list("--listing")) programs.symbols.add_listing(read_input_text(path));
  auto prepared = value_of(prepare(description, arguments, programs.reader()));
  if (prepared.machine->probe() == nullptr)
    throw base::usage_error(fmt::format("the {} does not support a monitor or an editor; `sightline run {}` runs it",
                                               description.name, description.name));
  return {std::move(prepared), std::move(programs.symbols)};
}

std::vector<machines::Option> monitor_options(const MachineDescription& machine) {
  std::vector<machines::Option> options;
  for (machines::Option option : machine.options) {
    if (option.kind == OptionKind::stream || option.kind == OptionKind::step || option.name == "--json") continue;
    if (option.kind == OptionKind::output) continue;
    options.push_back(option);
  }
  if (const auto* const dialect = dialect_option(machine)) options.push_back(*dialect);
  options.push_back({OptionKind::list, "--symbols", "FILE",
                     machine.radix == 16 ? "Symbols of the program, in a file of `sightline asm --symbols` or a .SYM file of MAC or LINK"
                                         : "Symbols of the program, in a file of `sightline asm --symbols`"});
  options.push_back({OptionKind::list, "--listing", "FILE", "Listing of the program; its lines are shown with the instructions"});
  options.push_back({OptionKind::list, "--do", "FILE", "Execute the commands of this file first"});
  options.push_back({.kind = OptionKind::text,
                     .name = "--radix",
                     .argument = "N",
                     .help = "Radix of the numbers that are typed and shown",
                     .choices = {"8", "10", "16"},
                     .initial = machine.radix == 8 ? "8" : "16"});
  return options;
}

void add_monitor_command(const Command& program) {
  const Command command = program.add_command("monitor", help_page("monitor"));
  for (const MachineDescription* machine : machines::machines()) {
    const HelpPage help = help_page("monitor_machine", {{"machine", std::string(machine->name)}});
    add_machine_command(command, machine->name, help, monitor_options(*machine),
                        [machine](const Arguments& arguments) { return monitor(*machine, arguments); });
  }
}

}  // namespace sightline::app
