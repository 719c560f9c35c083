#include "host/guests/flight/program.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

#include "host/base/result.hpp"
#include "tools/asm/i8080.hpp"

namespace sightline::guests::flight {

namespace {

std::optional<std::string> source_named(const std::string& name) {
  const auto sources = embedded_sources();
  const auto found = std::find_if(sources.begin(), sources.end(), [&](const auto& source) { return source.first == name; });
  if (found == sources.end()) return std::nullopt;
  return std::string(found->second);
}

}  // namespace

Program assemble_program() {
  assembler::I8080Options options;
  options.listing = false;
  options.include = source_named;
  const std::string name = "flight.asm";
  const std::vector<assembler::SourceFile> sources{{name, source_named(name).value_or("")}};
  const assembler::I8080Assembly assembly = assembler::assemble_i8080(sources, options);
  if (!assembly.ok()) {
    std::string text = "the flight program does not assemble:\n";
    for (const auto& diagnostic : assembly.diagnostics) text += assembler::to_string(diagnostic) + "\n";
    base::give_up(text);
  }
  Program program;
  const auto bytes = assembly.image.bytes().first(assembly.image.highest() + std::size_t{1});
  program.memory.assign(bytes.begin(), bytes.end());
  for (const auto& symbol : assembly.symbols) program.symbols.emplace(symbol.name, symbol.value);
  const auto at = [&program](std::string_view label) {
    const auto found = program.symbols.find(label);
    if (found == program.symbols.end()) base::give_up(fmt::format("the flight program has no label {}", label));
    return found->second;
  };
  program.start = at("START");
  program.status = at("STATUS");
  if (at("CODEND") > at("SQL")) base::give_up("the flight program reaches into its tables");
  return program;
}

}  // namespace sightline::guests::flight
