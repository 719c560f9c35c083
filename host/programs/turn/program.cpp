#include "host/programs/turn/program.hpp"

#include <fmt/core.h>

#include "host/base/result.hpp"
#include "tools/asm/pdp7.hpp"

namespace sightline::programs::turn {

Program assemble_program(bool eae, Memory memory) {
  std::vector<assembler::SourceFile> sources;
  for (const auto& [name, text] : firmware_tapes()) sources.push_back({std::string(name), std::string(text)});
  assembler::Options options;
  options.defines.push_back({"EAE", eae ? 1U : 0U});
  options.defines.push_back({"EXTEND", memory == Memory::words_32k ? 1U : 0U});
  const auto assembly = assembler::assemble_pdp7(sources, options);
  if (!assembly.ok()) {
    std::string text = "the program does not assemble:\n";
    for (const auto& diagnostic : assembly.diagnostics) text += to_string(diagnostic) + "\n";
    base::give_up(text);
  }
  const auto at = [&assembly](std::string_view name) {
    const auto value = assembly.value_of(name);
    if (!value) base::give_up(fmt::format("the program has no label {}", name));
    return *value;
  };
  Program program;
  program.eae = eae;
  program.memory = memory;
  program.core.resize(model_end(Memory::words_8k));
  for (const auto& [address, word] : assembly.image.words) program.core[address] = word;
  for (const auto& symbol : assembly.symbols) program.symbols.emplace(symbol.name, symbol.value);
  program.words = static_cast<std::uint32_t>(assembly.image.words.size());
  if (assembly.image.words.rbegin()->first >= model_base(Memory::words_8k) || at("model") != model_base(memory))
    base::give_up("the program overlaps the model");
  program.labels = {at("start"), at("begin"), at("count"), at("chksum"), at("pictur"), at("file"),  at("shown"),
                    at("dfs"),   at("angle"), at("status"), at("sw"),   at("waitlp"),  at("waited"),
                    at("vector") + 1, at("locate") + 1};
  return program;
}

}  // namespace sightline::programs::turn
