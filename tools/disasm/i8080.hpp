// The disassembler of the 8080. Its output is source for the 8080 assembler, which makes the same bytes of it; a comment
// on every line gives the address and the bytes in hexadecimal.
//
// Bytes are read one instruction after the other from the start of every run of addresses. An opcode that Intel left
// undefined acts as another one, which the assembler would write instead. Such an instruction is therefore shown as DB,
// and the comment says what it does. Bytes of an incomplete instruction at the end of a run are shown as DB, too.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "tools/image/binary.hpp"

namespace sightline::disassembler {

struct I8080Line {
  std::string text;  // "MVI     A,41H"
  int bytes = 1;
  bool duplicate = false;  // the assembler makes another opcode of the text
};

// The instruction of an opcode and the two bytes after it.
[[nodiscard]] I8080Line disassemble_i8080_instruction(std::array<std::uint8_t, 3> bytes);

[[nodiscard]] std::string disassemble_i8080(const image::ByteImage& image);

}  // namespace sightline::disassembler
