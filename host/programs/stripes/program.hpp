// The program of firmware/i8080/stripes, assembled from its embedded source: the bytes for memory, and the addresses of its
// labels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "emulators/i8080/state.hpp"
#include "host/programs/stripes/status.hpp"

namespace sightline::programs::stripes {

// (file name, text) of the program's sources; stripes.asm includes the others.
[[nodiscard]] std::span<const std::pair<std::string_view, std::string_view>> embedded_sources();

struct Labels {
  i8080::Address start = 0;    // start address of the processor
  i8080::Address status = 0;   // why the program stopped
  i8080::Address fault = 0;    // at which face
  i8080::Address check = 0;    // CHECK: the stream is in memory
  i8080::Address drawing = 0;  // DRAWIT: the priority list is complete
  i8080::Address order = 0;    // ORDER: that list
  // Labels for counting the work: for a pair of faces, tests 2 to 6, those with planes, the common stripes of test 6, "the
  // first hides the second" and the reverse without test 6, and a relation; the end of all pairs; a relation deleted or
  // cut; a line drawn.
  i8080::Address tests = 0;
  i8080::Address sides = 0;
  i8080::Address common = 0;
  i8080::Address first_hides = 0;
  i8080::Address second_hides = 0;
  i8080::Address hides = 0;
  i8080::Address classes = 0;
  i8080::Address deleted = 0;
  i8080::Address line_done = 0;
  i8080::Address cuts = 0;        // NCUT
  i8080::Address lines = 0;       // YLO, YHI: lines of the current face, first and one past the last
  i8080::Address face_slots = 0;  // FS: its lists, 16 bytes a line
  i8080::Address silhouette_slots = 0;  // SS: those of the silhouette, 32 bytes a line
  i8080::Address face_line = 0;   // FPTR: the list of the current line of the face
  i8080::Address shadow_line = 0; // SPTR: the same for the silhouette
  i8080::Address difference = 0;  // VTOP: below it, downwards, the list of the visible part, two bytes each, the upper the toggle
};

struct Program {
  std::vector<std::uint8_t> memory;  // from 0000 on: instructions, tables, variables
  Labels labels;
  Build build = Build::plain;
};

// Size of the area for the program, and for all its data (SPECIFICATION, section 7).
inline constexpr std::size_t program_room = 0x1000;
inline constexpr std::size_t data_room = 0xC000;

// Assembles the embedded program. It is part of this executable: an error ends the process with the assembler's messages.
[[nodiscard]] Program assemble_program(Build build = Build::plain);
// The same, assembled on the first call.
[[nodiscard]] const Program& resident_program(Build build = Build::plain);

}  // namespace sightline::programs::stripes
