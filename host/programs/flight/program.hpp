// The program of firmware/i8080/flight, assembled from its embedded source.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "emulators/i8080/state.hpp"

namespace sightline::programs::flight {

// (file name, text) of the program's sources; flight.asm and facing.asm include the others.
[[nodiscard]] std::span<const std::pair<std::string_view, std::string_view>> embedded_sources();

struct Program {
  bool facing = false;  // with the facing test
  std::vector<std::uint8_t> memory;  // from 0000 on
  i8080::Address start = 0;
  i8080::Address status = 0;  // STATUS: why the program stopped
  i8080::Address first = 0;   // the low byte of the order's first place: 256 less the number of pieces in it, modulo 256
  i8080::Address list_end = 0;  // after LIST: the pieces' numbers by distance, nearest first
};

// Assembles the embedded program. It is part of this build: an error ends the process with the assembler's messages.
// `facing`: the build with the facing test.
[[nodiscard]] Program assemble_program(bool facing = false);
// The same, assembled on the first call.
[[nodiscard]] const Program& resident_program(bool facing = false);

}  // namespace sightline::programs::flight
