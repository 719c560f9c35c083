// `sightline disasm`: a tape, a core image or a program file to source that assembles to the same words
// again.
#include <string>

#include "host/app/commands/commands.hpp"
#include "host/app/commands/machine_command.hpp"

namespace sightline::app {

namespace {

using guests::run::Arguments;
using guests::run::Disassembler;
using guests::run::MachineDescription;

ExitCode disassemble(const MachineDescription& machine, const Disassembler& disassembler,
                     const Arguments& arguments) {
  const auto file = accepted(file_argument(machine, "FILE", arguments.text("FILE")));
  const auto input = read_named(file.path);
  const auto program = accepted(read_program(machine, file, input, arguments.text("--format"), nullptr));
  Output output(arguments.text("--output"));
  output.write(disassembler.disassemble(program));
  output.commit();
  return ExitCode::ok;
}

std::vector<guests::run::Option> options_of(const MachineDescription& machine,
                                            const Disassembler& disassembler) {
  using enum guests::run::OptionKind;
  std::vector<guests::run::Option> options{{position, "FILE", {}, std::string(disassembler.file_help)}};
  if (has_endings(machine)) {
    options.push_back({.name = "--format",
                       .argument = "FORMAT",
                       .help = "Form of the file",
                       .choices = format_names(machine),
                       .shown_initial = "by its ending or content"});
  }
  options.push_back({.name = "-o,--output",
                     .argument = "FILE",
                     .help = "Where the source goes; - is standard output",
                     .initial = "-"});
  return options;
}

}  // namespace

void add_disasm_command(const Command& program) {
  const Command command = program.add_command("disasm", help_page("disasm"));
  for (const MachineDescription* machine : guests::run::machines()) {
    for (const Disassembler& disassembler : machine->disassemblers) {
      const HelpPage help = help_page("disasm_" + std::string(disassembler.name),
                                      {{"summary", std::string(disassembler.help)}});
      add_machine_command(command, disassembler.name, help, options_of(*machine, disassembler),
                          [machine, &disassembler](const Arguments& arguments) {
                            return disassemble(*machine, disassembler, arguments);
                          });
    }
  }
}

}  // namespace sightline::app
