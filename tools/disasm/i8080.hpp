// The disassembler of the 8080. Its output is source of the 8080 assembler that assembles to the same bytes
// again; a comment on every line gives the address and the bytes in hexadecimal.
//
// Bytes are read one instruction after the other from the start of every run of addresses. An opcode Intel
// left undefined repeats another, but the assembler would write the other one: such an instruction comes out
// as DB with what it does in the comment. So do the bytes at the end of a run that do not make a whole
// instruction.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "tools/image/binary.hpp"

namespace sightline::disassembler {

struct I8080Line {
  std::string text;  // "MVI     A,41H"
  int bytes = 1;
  bool duplicate = false;  // not the opcode the assembler makes of the text
};

// The instruction of an opcode and the two bytes behind it.
[[nodiscard]] I8080Line disassemble_i8080_instruction(std::array<std::uint8_t, 3> bytes);

[[nodiscard]] std::string disassemble_i8080(const image::ByteImage& image);

}  // namespace sightline::disassembler
