// Skala's resident program for the 8080, assembled from its source: the bytes for memory, and the addresses of its labels.
//
// The source (firmware/i8080/skala) is embedded, so commands need no files. One program draws every picture.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "emulators/i8080/state.hpp"

namespace sightline::programs::skala {

// (file name, text) of the program's sources; skala.asm includes the others.
[[nodiscard]] std::span<const std::pair<std::string_view, std::string_view>> embedded_sources();

// Labels of the program (NOTES.md maps the paper's terms to them).
struct Labels {
  i8080::Address start = 0;           // start address of the processor
  i8080::Address status = 0;          // why the program stopped
  i8080::Address link_switch = 0;     // LINKSW: 0 parallel, 1 serial
  i8080::Address drawing = 0;         // DRAWIT: the buffered commands are drawn from here on
  i8080::Address mask_top = 0;        // MT, a page
  i8080::Address mask_bottom = 0;     // MB
  i8080::Address previous_row = 0;    // MP
  i8080::Address previous_level = 0;  // IP
};

struct Program {
  std::vector<std::uint8_t> memory;  // from 0000 on: instructions, tables, variables
  Labels labels;
  bool direct_masks = false;
};

// Assembles the embedded program. It is part of this build: an error ends the process with the assembler's messages.
// `direct_masks`: the build without the temporary masks M1T and M1B (SPECIFICATION, section 10).
[[nodiscard]] Program assemble_program(bool direct_masks = false);
// The same, assembled on the first call.
[[nodiscard]] const Program& resident_program(bool direct_masks = false);

}  // namespace sightline::programs::skala
