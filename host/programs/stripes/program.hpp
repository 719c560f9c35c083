// The program of firmware/i8080/stripes, assembled from its embedded source: the bytes for memory, and where its labels are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "emulators/i8080/state.hpp"

namespace sightline::programs::stripes {

// (file name, text) of the program's sources; stripes.asm includes the others.
[[nodiscard]] std::span<const std::pair<std::string_view, std::string_view>> embedded_sources();

struct Labels {
  i8080::Address start = 0;    // where the processor is started
  i8080::Address status = 0;   // why the program stopped
  i8080::Address fault = 0;    // at which face
  i8080::Address check = 0;    // CHECK: the stream is in memory
  i8080::Address drawing = 0;  // DRAWIT: the priority list is complete
  i8080::Address order = 0;    // ORDER: that list
};

struct Program {
  std::vector<std::uint8_t> memory;  // from 0000 on: instructions, tables, variables
  Labels labels;
};

// Room for the program, and for all its data (SPECIFICATION, section 7).
inline constexpr std::size_t program_room = 0x1000;
inline constexpr std::size_t data_room = 0xC000;

// std::logic_error with the assembler's messages if it has an error: it is part of this build.
[[nodiscard]] Program assemble_program();

}  // namespace sightline::programs::stripes
