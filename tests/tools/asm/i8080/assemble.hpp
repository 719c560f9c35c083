// Helpers for tests of the 8080 assembler: one source text in, bytes and messages out.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tools/asm/i8080.hpp"

namespace sightline::assembler {

using Files = std::map<std::string, std::string>;
using Bytes = std::vector<std::uint8_t>;
using Texts = std::vector<std::string>;

inline I8080Assembly assemble8080(std::string text, I8080Options options = {}, const Files& files = {}) {
  options.include = [&files](const std::string& path) -> std::optional<std::string> {
    const auto found = files.find(path);
    return found == files.end() ? std::nullopt : std::optional(found->second);
  };
  const std::vector<SourceFile> sources{{"t.asm", std::move(text)}};
  return assemble_i8080(sources, options);
}

// From the lowest to the highest address; gaps as 00.
inline Bytes bytes_of(const I8080Assembly& assembly) {
  if (assembly.image.empty()) return {};
  const auto all = assembly.image.bytes();
  return {all.begin() + assembly.image.lowest(), all.begin() + assembly.image.highest() + 1};
}

inline Bytes bytes8080(std::string text) {
  return bytes_of(assemble8080(std::move(text)));
}

inline Texts messages(const I8080Assembly& assembly) {
  Texts texts;
  for (const Diagnostic& diagnostic : assembly.diagnostics) texts.push_back(to_string(diagnostic));
  return texts;
}

inline Texts messages8080(std::string text) {
  return messages(assemble8080(std::move(text)));
}

}  // namespace sightline::assembler
