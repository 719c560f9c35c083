// What the passes of both dialects of the PDP-7 make.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/asm/engine.hpp"

namespace sightline::assembler {

struct EmittedWord {
  Position at;
  std::uint32_t address = 0;
  std::uint32_t word = 0;
  std::string generated_source;  // the source of a literal or variable; empty for a word of the source
};

struct Pdp7Program {
  Pdp7Program(std::span<const SourceFile> sources, const Naming& naming) : engine(sources, naming, 8, 6) {}

  // In the last pass: a word of the program. `cell` is what a message calls a place in core, `shown` its address.
  void put(const Position& at, std::uint32_t address, std::uint32_t word, const std::string& shown, std::string_view cell,
           std::string generated_source = {}) {
    if (const auto first = engine.put(address, word, at)) {
      engine.warning(at, "a second word at " + shown + ", which replaces that of " + engine.where(*first),
                     "one word per " + std::string(cell));
    }
    words.push_back({at, address, word, std::move(generated_source)});
  }

  Engine engine;
  std::vector<EmittedWord> words;
  std::optional<std::uint32_t> start;  // of START
  std::optional<std::uint32_t> base;   // `..` of the dialect of Bell Laboratories, if the source sets it
};

}  // namespace sightline::assembler
