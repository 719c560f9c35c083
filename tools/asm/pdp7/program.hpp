// What the passes of both dialects of the PDP-7 make.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "tools/asm/engine.hpp"

namespace sightline::assembler {

struct Pdp7Program {
  Pdp7Program(std::span<const SourceFile> sources, const Naming& naming) : engine(sources, naming, octal_words) {}

  void begin_source(std::size_t index) {
    end_source();
    engine.begin_source(index);
    if (engine.final() && engine.sources() > 1) static_cast<void>(engine.add_line("/ " + engine.file(index).name));
  }
  void end_source() {
    if (engine.final()) engine.line_at({0, static_cast<std::size_t>(-1), 1});
  }

  // In the last pass: a word of the program. `cell` is what a message calls a place in core, `shown` its address.
  void put(const Position& at, std::uint32_t address, std::uint32_t word, const std::string& shown, std::string_view cell,
           std::string note = {}) {
    ListedLine& line = engine.line_at(at);
    line.cells = 0;
    if (const auto first = engine.put(address, word, at, line, std::move(note))) {
      engine.warning(at, "a second word at " + shown + ", which replaces that of " + engine.where(*first),
                     "one word per " + std::string(cell));
    }
  }

  Engine engine;
  std::optional<std::uint32_t> start;  // of START
  std::optional<std::uint32_t> base;   // `..` of the dialect of Bell Laboratories, if the source sets it
};

}  // namespace sightline::assembler
