#include "host/guests/stripes/program.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <string>

#include "host/base/result.hpp"
#include "tools/asm/i8080.hpp"

namespace sightline::guests::stripes {

namespace {

constexpr std::string_view main_source = "stripes.asm";

std::optional<std::string> source_text(const std::string& name) {
  const auto sources = embedded_sources();
  const auto found =
      std::find_if(sources.begin(), sources.end(), [&](const auto& source) { return source.first == name; });
  if (found == sources.end()) return std::nullopt;
  return std::string(found->second);
}

}  // namespace

Program assemble_program() {
  assembler::I8080Options options;
  options.listing = false;
  options.include = source_text;
  const std::string name(main_source);
  const std::vector<assembler::SourceFile> sources{{name, source_text(name).value_or("")}};
  const assembler::I8080Assembly assembly = assembler::assemble_i8080(sources, options);
  if (!assembly.ok()) {
    std::string text = "the program of stripes does not assemble:\n";
    for (const auto& diagnostic : assembly.diagnostics) text += assembler::to_string(diagnostic) + "\n";
    base::give_up(text);
  }
  const auto at = [&](std::string_view label) {
    const auto value = assembly.value_of(label);
    if (!value) base::give_up(fmt::format("the program of stripes has no label {}", label));
    return *value;
  };
  const auto bytes = assembly.image.bytes().first(assembly.image.highest() + std::size_t{1});
  if (bytes.size() > program_room) base::give_up("the program of stripes reaches into its data");
  return {{bytes.begin(), bytes.end()},
          {at("START"), at("STATUS"), at("FAULT"), at("CHECK"), at("RANKIT"), at("DRAWIT"), at("ORDER")}};
}

}  // namespace sightline::guests::stripes
