// `sightline disasm`: disassembles a tape, a core image or a program file to source that assembles to the same words.
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/app/commands/commands.hpp"
#include "host/app/commands/machine_command.hpp"

namespace sightline::app {

namespace {

using machines::Arguments;
using machines::Disassembler;
using machines::MachineDescription;

std::optional<std::uint32_t> address_argument(const MachineDescription& machine, const Arguments& arguments,
                                              const char* option) {
  if (!arguments.given(option)) return std::nullopt;
  return value_of(machines::number_argument(option, arguments.text(option), machine.radix,
                                               (1U << machine.address_bits) - 1, "an address"));
}

// Removes the words outside `first` to `last`. Error bad_input if none remain.
void keep_range(machines::Program& program, std::uint32_t first, std::uint32_t last) {
  if (first > last) throw base::usage_error("--end: found an address below --start, expected one above it");
  const bool any = !program.words.empty();
  std::erase_if(program.words, [&](const auto& word) { return word.first < first || word.first > last; });
  if (any && program.words.empty())
    throw base::bad_input("--start, --end: found no word of the program in this range, expected one");
}

// Error bad_input: the dialect cannot express the program.
std::string source_of(const Disassembler& disassembler, const machines::Program& program, const Arguments& arguments,
                      const std::string& file) {
  for (const auto& [name, write] : disassembler.dialects.others)
    if (arguments.text("--dialect") == name) return value_of(write(program, file));
  return disassembler.disassemble(program);
}

ExitCode disassemble(const MachineDescription& machine, const Disassembler& disassembler,
                     const Arguments& arguments) {
  const auto file = value_of(file_argument(machine, "FILE", arguments.text("FILE")));
  const auto input = read_named(file.path);
  auto program = value_of(read_program(machine, file, input, arguments.text("--format"), nullptr));
  for (const std::string& warning : program.warnings) warn(warning);
  keep_range(program, address_argument(machine, arguments, "--start").value_or(0),
             address_argument(machine, arguments, "--end").value_or(UINT32_MAX));
  const std::string source = source_of(disassembler, program, arguments, input.name);
  Output output(arguments.text("--output"));
  output.write(source);
  output.commit();
  report_written(arguments.text("--output"),
              count_text(static_cast<std::uint64_t>(std::count(source.begin(), source.end(), '\n')), "line"));
  return ExitCode::ok;
}

std::vector<machines::Option> options_of(const MachineDescription& machine,
                                            const Disassembler& disassembler) {
  using enum machines::OptionKind;
  std::vector<machines::Option> options{{position, "FILE", {}, std::string(disassembler.file_help)}};
  if (has_endings(machine)) {
    options.push_back({.name = "--format",
                       .argument = "FORMAT",
                       .help = "Format of the file",
                       .choices = format_names(machine),
                       .shown_initial = "by its extension or content"});
  }
  options.push_back({text, "--start", "ADDRESS", "Begin at this address and omit the words below it"});
  options.push_back({text, "--end", "ADDRESS", "Stop after this address"});
  if (!disassembler.dialects.others.empty()) {
    std::vector<std::string_view> names{disassembler.dialects.own};
    for (const auto& [name, write] : disassembler.dialects.others) names.push_back(name);
    options.push_back({.name = "--dialect",
                       .argument = "NAME",
                       .help = "Language of the source, as `sightline asm --dialect` reads it",
                       .choices = names,
                       .initial = disassembler.dialects.own});
  }
  options.push_back({.name = "-o,--output",
                     .argument = "FILE",
                     .help = "The source; - is standard output",
                     .initial = "-"});
  return options;
}

}  // namespace

void add_disasm_command(const Command& program) {
  const Command command = program.add_command("disasm", help_page("disasm"));
  for (const MachineDescription* machine : machines::machines()) {
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
