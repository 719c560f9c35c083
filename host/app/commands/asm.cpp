// `sightline asm`: assembles source to a tape, a core image or a program file, with a listing and a symbol table.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/app/commands/commands.hpp"
#include "host/app/commands/machine_command.hpp"
#include "host/app/commands/program_sources.hpp"
#include "host/app/outputs.hpp"

namespace sightline::app {

namespace {

using machines::Arguments;
using machines::Format;
using machines::MachineDescription;
using machines::Program;

constexpr std::array<std::pair<const char*, const char*>, 3> output_options{
    {{"-o", "--output"}, {"--listing", "--listing"}, {"--symbols", "--symbols"}}};  // name in messages, name in Arguments

// Error usage: two outputs are the same file or both standard output, or an output is a source. Files that are not regular
// (/dev/null) may be named several times.
void reject_clashing_files(const Arguments& arguments) {
  for (std::size_t i = 0; i < output_options.size(); ++i) {
    const auto& [option, key] = output_options[i];
    const std::string& name = arguments.text(key);
    if (name.empty()) continue;
    for (std::size_t other = 0; other < i; ++other) {
      const std::string& before = arguments.text(output_options[other].second);
      if (!before.empty() && are_one_file(name, before))
        throw base::usage_error(fmt::format("{}: found {}, expected another file than that of {}",
                                                   option, display_name(name), output_options[other].first));
    }
    for (const std::string& source : arguments.list("SOURCE")) {
      if (name != "-" && are_one_file(name, source))
        throw base::usage_error(fmt::format("{}: found {}, expected no file that is a source", option, name));
    }
  }
}

// The format of --format, or else that of the output's extension.
const Format& output_format(const MachineDescription& machine, const Arguments& arguments) {
  const Format* const by_name = format_by_name(machine, arguments.text("--output"));
  const bool decides = arguments.text("--format").empty();
  if (decides && by_name != nullptr) return *by_name;
  const std::string name = decides ? std::string(machine.assembler.format) : arguments.text("--format");
  return *std::find_if(machine.formats.begin(), machine.formats.end(),
                       [&name](const Format& format) { return format.name == name; });
}

std::string summary(const MachineDescription& machine, const Arguments& arguments,
                    const machines::Assembled& assembled) {
  const Program& program = assembled.program;
  const auto address = [&machine](std::uint32_t a) { return digits(machine, a, machine.address_bits); };
  std::string text = fmt::format("{} {}", program.words.size(), machine.word_bits == 8 ? "bytes" : "words");
  if (!program.words.empty())
    text +=
        fmt::format(" in {}-{}", address(program.words.front().first), address(program.words.back().first));
  text += program.start ? ", start " + address(*program.start) : ", no start address";
  text += fmt::format(", {} symbols", assembled.symbols);
  if (!arguments.given("--output")) return text + "; checked only, -o FILE writes it";
  if (output_format(machine, arguments).tells_address && !program.words.empty())
    text += fmt::format("; load it @{:o}", program.words.front().first);
  return text;
}

// Writes all outputs or none. Error io.
void write_files(const MachineDescription& machine, const Arguments& arguments,
                 const machines::Assembled& assembled) {
  const std::string& path = arguments.text("--output");
  machines::Bytes program;
  if (!path.empty()) {
    program = value_of(
        output_format(machine, arguments).write(assembled.program, path == "-" ? "standard output" : path));
  }
  std::vector<Output> outputs;
  if (!path.empty()) outputs.emplace_back(path).write(std::span<const std::uint8_t>(program));
  if (arguments.given("--listing"))
    outputs.emplace_back(arguments.text("--listing")).write(assembled.listing);
  if (arguments.given("--symbols"))
    outputs.emplace_back(arguments.text("--symbols")).write(assembled.symbol_table);
  for (Output& output : outputs) output.commit();
}

ExitCode assemble(const MachineDescription& machine, const Arguments& arguments) {
  reject_clashing_files(arguments);
  std::vector<assembler::SourceFile> sources;
  for (const std::string& path : arguments.list("SOURCE"))
    sources.push_back({display_name(path), read_input_text(path)});
  const machines::Assembled assembled =
      value_of(machine.assembler.assemble(sources, arguments, read_include));
  for (const auto& diagnostic : assembled.diagnostics)
    fmt::print(stderr, "{}\n", assembler::to_string(diagnostic));
  if (assembler::any_errors(assembled.diagnostics)) {
    suggest_other_machine(machine, sources, "asm", arguments.list("SOURCE"));
    throw base::bad_input("the source has errors; nothing was written");
  }
  write_files(machine, arguments, assembled);
  print_message(summary(machine, arguments, assembled));
  return ExitCode::ok;
}

std::vector<machines::Option> options_of(const MachineDescription& machine) {
  using enum machines::OptionKind;
  const bool by_ending = has_endings(machine);
  std::vector<machines::Option> options{
      {positions, "SOURCE", {}, "Source files, in order; - is standard input"},
      {list, "-D", "NAME=VALUE",
       fmt::format("Define a symbol, NAME=VALUE, VALUE {}; wins over the source's own",
                   machine.assembler.define_value)},
      {text, "-o,--output", "FILE", "The program; - is standard output"},
      {.name = "--format",
       .argument = "FORMAT",
       .help = "Format of the program",
       .choices = format_names(machine),
       .initial = by_ending ? "" : machine.assembler.format,
       .shown_initial = by_ending ? "by the extension of -o" : ""},
      {text, "--listing", "FILE", std::string(machine.assembler.listing_help)},
      {text, "--symbols", "FILE", "Write the symbols, one line `name value` for each"}};
  options.insert(options.end(), machine.assembler.options.begin(), machine.assembler.options.end());
  return options;
}

}  // namespace

void add_asm_command(const Command& program) {
  const Command command = program.add_command("asm", help_page("asm"));
  for (const MachineDescription* machine : machines::machines()) {
    if (machine->assembler.assemble == nullptr) continue;
    const HelpPage help = help_page("asm_" + std::string(machine->name),
                                    {{"summary", std::string(machine->assembler.help)}});
    add_machine_command(command, machine->name, help, options_of(*machine),
                        [machine](const Arguments& arguments) { return assemble(*machine, arguments); });
  }
}

}  // namespace sightline::app
