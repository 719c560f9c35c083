// `sightline monitor`: a machine stopped, looked into and run on, at a prompt or by a file of commands.
#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "host/app/commands/commands.hpp"
#include "host/app/commands/machine_command.hpp"
#include "host/app/commands/monitor_session.hpp"
#include "host/live/symbols.hpp"

namespace sightline::app {

namespace {

using guests::run::Arguments;
using guests::run::Machine;
using guests::run::MachineDescription;
using guests::run::OptionKind;

// --- Programs ---

// The programs of a command line, with those that are sources assembled in place, and the symbols of all.
struct Programs {
  std::map<std::string, base::Bytes> assembled;  // under the names that --load has for them now
  live::Symbols symbols;
};

std::string first_error(const std::vector<assembler::Diagnostic>& diagnostics) {
  for (const auto& diagnostic : diagnostics)
    if (diagnostic.severity == assembler::Severity::error) return assembler::to_string(diagnostic);
  return {};
}

// The assembler's option of which language sources are in; null if it reads one.
const guests::run::Option* dialect_option(const MachineDescription& machine) {
  const auto& options = machine.assembler.options;
  const auto found = std::find_if(options.begin(), options.end(), [](const auto& each) { return each.name == "--dialect"; });
  return found == options.end() ? nullptr : &*found;
}

// Replaces sources in --load by what they assemble to. Failure bad_input.
Programs assemble_sources(const MachineDescription& machine, Arguments& arguments) {
  Programs programs{{}, live::Symbols(machine.radix)};
  const auto form = std::find_if(machine.formats.begin(), machine.formats.end(), [&machine](const auto& format) {
    return format.name == machine.assembler.format;
  });
  // Sources side by side are one program, as those of a command line of `sightline asm` are.
  std::vector<std::string>& loads = arguments.value("--load").list;
  for (auto first = loads.begin(); first != loads.end(); ++first) {
    const auto last = std::find_if_not(first, loads.end(), guests::run::named_as_source);
    if (first == last) continue;
    std::vector<assembler::SourceFile> sources;
    for (auto path = first; path != last; ++path) sources.push_back({*path, read_input_text(*path)});
    Arguments options(machine.assembler.options);
    options.value("--listing").flag = true;
    if (dialect_option(machine) != nullptr) options.value("--dialect").text = arguments.text("--dialect");
    const auto assembled = accepted(machine.assembler.assemble(sources, options, read_include));
    for (const auto& diagnostic : assembled.diagnostics)
      fmt::print(stderr, "{}\n", assembler::to_string(diagnostic));
    if (assembler::any_errors(assembled.diagnostics))
      throw Failure(ExitCode::bad_input, fmt::format("{}: the source has errors: {}", *first, first_error(assembled.diagnostics)));
    static_cast<void>(programs.symbols.add_table(assembled.symbol_table));
    programs.symbols.add_listing(assembled.listing);
    for (const guests::run::SourceLine& line : assembled.lines)
      programs.symbols.add_line(line.address, {line.file, line.line});
    *first += std::string(": ") + std::string(form->name);
    programs.assembled[*first] = accepted(form->write(assembled.program, *first));
    first = loads.erase(first + 1, last) - 1;
  }
  for (const std::string& path : arguments.list("--symbols"))
    static_cast<void>(value_of(programs.symbols.add_table(read_input_text(path)), path));
  for (const std::string& path : arguments.list("--listing")) programs.symbols.add_listing(read_input_text(path));
  return programs;
}

ExitCode monitor(const MachineDescription& description, const Arguments& arguments) {
  MonitoredMachine made = make_monitored(description, arguments);
  for (const std::string& warning : made.prepared.warnings) warn(warning);
  Machine& machine = *made.prepared.machine;
  const ExitCode code = hold_monitor_session({description, machine, made.prepared.limits, std::move(made.symbols), arguments});
  write_media_back(machine);
  return code;
}

}  // namespace

MonitoredMachine make_monitored(const MachineDescription& description, Arguments arguments) {
  arguments.value("--monitor").flag = true;
  check_disk(arguments);
  Programs programs = assemble_sources(description, arguments);
  auto prepared = accepted(prepare(description, arguments, [&programs](const std::string& path) {
    const auto found = programs.assembled.find(path);
    return found == programs.assembled.end() ? read_named(path) : guests::run::Input{path, found->second};
  }));
  if (prepared.machine->probe() == nullptr)
    throw Failure(ExitCode::usage, fmt::format("the {} has no probe for a monitor or an editor; `sightline run {}` runs it",
                                               description.name, description.name));
  return {std::move(prepared), std::move(programs.symbols)};
}

std::vector<guests::run::Option> monitor_options(const MachineDescription& machine) {
  std::vector<guests::run::Option> options;
  for (guests::run::Option option : machine.options) {
    if (option.kind == OptionKind::stream || option.kind == OptionKind::step || option.name == "--json") continue;
    if (option.kind == OptionKind::output) continue;
    options.push_back(option);
  }
  if (const auto* const dialect = dialect_option(machine)) options.push_back(*dialect);
  options.push_back({OptionKind::list, "--symbols", "FILE", "Symbols of the program, as `sightline asm --symbols` writes them"});
  options.push_back({OptionKind::list, "--listing", "FILE", "Its listing, whose lines are shown with the instructions"});
  options.push_back({OptionKind::list, "--do", "FILE", "Commands to begin with"});
  options.push_back({.kind = OptionKind::text,
                     .name = "--radix",
                     .argument = "N",
                     .help = "Of the numbers that are typed and shown",
                     .choices = {"8", "10", "16"},
                     .initial = machine.radix == 8 ? "8" : "16"});
  return options;
}

void add_monitor_command(const Command& program) {
  const Command command = program.add_command("monitor", help_page("monitor"));
  for (const MachineDescription* machine : guests::run::machines()) {
    const HelpPage help = help_page("monitor_machine", {{"machine", std::string(machine->name)}});
    add_machine_command(command, machine->name, help, monitor_options(*machine),
                        [machine](const Arguments& arguments) { return monitor(*machine, arguments); });
  }
}

}  // namespace sightline::app
