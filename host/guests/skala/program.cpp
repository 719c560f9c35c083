#include "host/guests/skala/program.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "host/base/result.hpp"
#include "tools/asm/i8080.hpp"

namespace sightline::guests::skala {

namespace {

constexpr std::string_view main_source = "skala.asm";

std::optional<std::string> embedded_source(const std::string& name) {
  const auto sources = embedded_sources();
  const auto found =
      std::find_if(sources.begin(), sources.end(), [&](const auto& source) { return source.first == name; });
  if (found == sources.end()) return std::nullopt;
  return std::string(found->second);
}

Labels labels_of(const assembler::I8080Assembly& assembly) {
  const auto at = [&](std::string_view name) {
    const auto value = assembly.value_of(name);
    if (!value) base::give_up(fmt::format("the Skala program has no label {}", name));
    return *value;
  };
  Labels labels;
  labels.start = at("START");
  labels.status = at("STATUS");
  labels.link_switch = at("LINKSW");
  labels.drawing = at("DRAWIT");
  labels.mask_top = at("MT");
  labels.mask_bottom = at("MB");
  labels.previous_row = at("MP");
  labels.previous_level = at("IP");
  return labels;
}

}  // namespace

Program assemble_program() {
  assembler::I8080Options options;
  options.listing = false;
  options.include = embedded_source;
  const std::string name(main_source);
  const std::vector<assembler::SourceFile> sources{{name, embedded_source(name).value_or("")}};
  const assembler::I8080Assembly assembly = assembler::assemble_i8080(sources, options);
  if (!assembly.ok()) {
    std::string text = "the Skala program does not assemble:\n";
    for (const auto& diagnostic : assembly.diagnostics) text += assembler::to_string(diagnostic) + "\n";
    base::give_up(text);
  }
  const auto bytes = assembly.image.bytes().first(assembly.image.highest() + std::size_t{1});
  return {{bytes.begin(), bytes.end()}, labels_of(assembly)};
}

}  // namespace sightline::guests::skala
