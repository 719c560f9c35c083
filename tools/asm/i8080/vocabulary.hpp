// The words that an 8080 source cannot use as names: mnemonics (of the instruction table), directives, operators, registers.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "emulators/i8080/isa.hpp"

namespace sightline::assembler {

enum class Directive : std::uint8_t {
  org,
  equ,
  set,
  db,
  dw,
  ds,
  dc,
  end,
  if_,
  if_zero,
  if_defined,
  if_not_defined,
  if_blank,
  if_not_blank,
  if_same,
  if_different,
  if_first_pass,
  if_second_pass,
  else_,
  endif,
  macro,
  endm,
  local,
  rept,
  irp,
  irpc,
  exitm,
  include,
  maclib,
  external,
  public_,
  cpu,
  z80,
  title,    // TITLE and SUBTTL: the operand is any text; no effect
  radix,
  phase,
  dephase,
  comment,
  common,
  segment,  // ASEG CSEG DSEG: one location for all, but they end a COMMON block
  ignored,  // listing controls, NAME: no effect in one absolute program
};

enum class Operator : std::uint8_t {
  multiply,
  divide,
  mod,
  shl,
  shr,
  add,
  subtract,
  eq,
  ne,
  lt,
  le,
  gt,
  ge,
  not_,
  and_,
  or_,
  xor_,
  high,
  low,
  nul,
};

// The rows of the instruction table with the same mnemonic: they differ in which operands are registers and which are M.
using Mnemonic = std::vector<const i8080::Instruction*>;

enum class WordKind : std::uint8_t { mnemonic, directive, operation, register_name };

struct Word {
  WordKind kind = WordKind::mnemonic;
  Mnemonic rows;
  Directive directive = Directive::ignored;
  Operator operation = Operator::add;
  std::uint8_t value = 0;  // of a register: its code; SP and PSW are 6
};

// By folded name; nullptr if the word is not reserved.
[[nodiscard]] const Word* find_word(const std::string& name);

}  // namespace sightline::assembler
