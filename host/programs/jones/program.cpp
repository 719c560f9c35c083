#include "host/programs/jones/program.hpp"

#include <fmt/core.h>

#include "host/base/result.hpp"
#include "tools/asm/pdp7.hpp"

namespace sightline::programs::jones {

namespace {

// The tables that the program places by assignment are not in the image.
std::uint32_t words_of(const assembler::Assembly& assembly, std::string_view name) {
  const auto value = assembly.value_of(name);
  if (!value) base::give_up(fmt::format("the program has no label {}", name));
  return *value;
}

Labels labels_of(const assembler::Assembly& assembly, const Build& build) {
  const auto at = [&](std::string_view name) { return words_of(assembly, name); };
  Labels labels;
  labels.start = at("start");
  labels.clock = at("clkop");
  labels.scale = at("scale0");
  labels.search = at("search");
  labels.visit = at("visit");
  labels.opening = at("opens");
  labels.line = at("clip2") + 1;
  labels.piece = at("drawn");
  labels.file = at("file");
  labels.views = at("views");
  labels.file_begun = at("dfs");
  labels.status = at("status");
  labels.scene = at("scene");
  labels.file_words = at("filsiz");
  labels.eye = at("ex");
  if (build.walk) {
    labels.steps = at("step");
    labels.stops = at("stops");
  }
  if (build.rotation) {
    labels.first_angle = at("angle0");
    labels.angle = at("angle");
  }
  return labels;
}

std::vector<assembler::SourceFile> sources_with(const std::string& tape) {
  std::vector<assembler::SourceFile> sources;
  for (const auto& [name, text] : firmware_tapes()) sources.push_back({std::string(name), std::string(text)});
  sources.push_back({"scene tape", tape});
  return sources;
}

std::string all_diagnostics(const assembler::Assembly& assembly) {
  std::string text;
  for (const auto& diagnostic : assembly.diagnostics) text += to_string(diagnostic) + "\n";
  return text;
}

}  // namespace

base::Result<Program> assemble_program(const scene::CellScene& scene, const Build& build,
                                       std::optional<geometry::Point> eye) {
  const Tape kind = build.walk ? Tape::walk : Tape::view;
  auto tape = write_tape(scene, eye, kind);
  if (!tape) return tape.error();
  assembler::Options assembler_options;
  assembler_options.defines.push_back({"EAE", build.eae ? 1U : 0U});
  assembler_options.defines.push_back({"FRACTION", build.fraction_bits});
  assembler_options.defines.push_back({"TRUNCATE", build.truncate ? 1U : 0U});
  assembler_options.defines.push_back({"WALK", build.walk ? 1U : 0U});
  assembler_options.defines.push_back({"ROTATE", build.rotation ? 1U : 0U});
  const auto assembly = assembler::assemble_pdp7(sources_with(*tape), assembler_options);
  if (!assembly.ok()) base::give_up("the program does not assemble:\n" + all_diagnostics(assembly));

  const std::uint32_t tables = words_of(assembly, "recs");
  const std::uint32_t end = assembly.image.words.rbegin()->first + 1;
  if (end > tables) {
    return base::Error{
        "", "",
        fmt::format("found {} words too many for the machine's core beside the program", end - tables)};
  }
  Program program;
  program.build = build;
  program.labels = labels_of(assembly, build);
  program.core.resize(core_words);
  for (const auto& [address, word] : assembly.image.words) program.core[address] = word;
  for (const auto& symbol : assembly.symbols) program.symbols.emplace(symbol.name, symbol.value);
  auto encoded = encode(scene, eye, program.labels.scene, kind);
  if (!encoded) return encoded.error();
  program.scene = std::move(*encoded);
  program.program_words = static_cast<std::uint32_t>(assembly.image.words.size() - program.scene.words.size());
  program.words_used = core_words - (tables - end);
  return program;
}

}  // namespace sightline::programs::jones
