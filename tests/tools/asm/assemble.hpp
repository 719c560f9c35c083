// Helpers for tests of the assembler: one source text in, words and messages out.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/asm/pdp7.hpp"

namespace sightline::assembler {

inline Assembly assemble(std::string text, const Options& options = {}) {
  const std::vector<SourceFile> sources{{"t.s", std::move(text)}};
  return assemble_pdp7(sources, options);
}

inline std::vector<std::string> messages(const Assembly& assembly) {
  std::vector<std::string> texts;
  for (const Diagnostic& diagnostic : assembly.diagnostics) texts.push_back(to_string(diagnostic));
  return texts;
}

// The consecutive words from address `from` on.
inline std::vector<std::uint32_t> words(const Assembly& assembly, std::uint32_t from = 0) {
  std::vector<std::uint32_t> values;
  const auto& core = assembly.image.words;
  for (auto at = core.find(from); at != core.end() && at->first == from; ++at, ++from) {
    values.push_back(at->second.value());
  }
  return values;
}

using Words = std::vector<std::uint32_t>;
using Texts = std::vector<std::string>;

}  // namespace sightline::assembler
