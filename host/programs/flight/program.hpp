// The program of firmware/i8080/flight, assembled from its embedded source.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "emulators/i8080/state.hpp"

namespace sightline::programs::flight {

// (file name, text) of the program's sources; flight.asm includes the others.
[[nodiscard]] std::span<const std::pair<std::string_view, std::string_view>> embedded_sources();

struct Program {
  std::vector<std::uint8_t> memory;  // from 0000 on
  i8080::Address start = 0;
  i8080::Address status = 0;  // STATUS: why the program stopped
  std::map<std::string, i8080::Address, std::less<>> symbols;
};

// The embedded program; it is part of this build, and gives up with the assembler's messages if it has an error.
[[nodiscard]] Program assemble_program();

}  // namespace sightline::programs::flight
