#include "host/app/commands/program_sources.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "host/app/commands/machine_command.hpp"

namespace sightline::app {

namespace {

using machines::Arguments;
using machines::MachineDescription;

std::string first_error(const std::vector<assembler::Diagnostic>& diagnostics) {
  for (const auto& diagnostic : diagnostics)
    if (diagnostic.severity == assembler::Severity::error) return assembler::to_string(diagnostic);
  return {};
}

}  // namespace

machines::FileReader Programs::reader() const {
  return [this](const std::string& path) {
    const auto found = assembled.find(path);
    return found == assembled.end() ? read_named(path) : machines::Input{path, found->second};
  };
}

const machines::Option* dialect_option(const MachineDescription& machine) {
  const auto& options = machine.assembler.options;
  const auto found = std::find_if(options.begin(), options.end(), [](const auto& each) { return each.name == "--dialect"; });
  return found == options.end() ? nullptr : &*found;
}

void suggest_other_machine(const MachineDescription& machine, std::span<const assembler::SourceFile> sources, std::string_view command,
                      std::span<const std::string> names) {
  for (const MachineDescription* other : machines::machines()) {
    if (other == &machine || other->assembler.assemble == nullptr) continue;
    const auto assembled = other->assembler.assemble(sources, Arguments(other->assembler.options), read_include);
    if (!assembled || assembler::any_errors(assembled->diagnostics)) continue;
    std::string files;
    for (const std::string& name : names) files += " " + name;
    print_message(fmt::format("this looks like {} source: sightline {} {}{}", other->name, command, other->name, files));
    return;
  }
}

Programs assemble_sources(const MachineDescription& machine, Arguments& arguments, std::string_view command) {
  Programs programs{{}, live::Symbols(machine.radix)};
  if (machine.assembler.assemble == nullptr) return programs;
  const auto form = std::find_if(machine.formats.begin(), machine.formats.end(), [&machine](const auto& format) {
    return format.name == machine.assembler.format;
  });
  // Adjacent sources are one program, as in `sightline asm`.
  std::vector<std::string>& loads = arguments.value("--load").list;
  for (auto first = loads.begin(); first != loads.end(); ++first) {
    const auto last = std::find_if_not(first, loads.end(), machines::named_as_source);
    if (first == last) continue;
    std::vector<assembler::SourceFile> sources;
    for (auto path = first; path != last; ++path) sources.push_back({*path, read_input_text(*path)});
    Arguments options(machine.assembler.options);
    options.value("--listing").flag = true;
    if (dialect_option(machine) != nullptr) options.value("--dialect").text = arguments.text("--dialect");
    const auto assembled = value_of(machine.assembler.assemble(sources, options, read_include));
    for (const auto& diagnostic : assembled.diagnostics)
      fmt::print(stderr, "{}\n", assembler::to_string(diagnostic));
    if (assembler::any_errors(assembled.diagnostics)) {
      suggest_other_machine(machine, sources, command, {first, last});
      throw base::bad_input(fmt::format("{}: the source has errors: {}", *first, first_error(assembled.diagnostics)));
    }
    static_cast<void>(programs.symbols.add_table(assembled.symbol_table));
    programs.symbols.add_listing(assembled.listing);
    for (const machines::SourceLine& line : assembled.lines)
      programs.symbols.add_line(line.address, {line.file, line.line});
    *first += std::string(": ") + std::string(form->name);
    programs.assembled[*first] = value_of(form->write(assembled.program, *first));
    first = loads.erase(first + 1, last) - 1;
  }
  return programs;
}

}  // namespace sightline::app
