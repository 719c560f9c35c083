// The 8080's instruction set: one table that the processor, the assembler, the disassembler and the trace read.
//
// A row describes the opcodes that differ only in a field named by its operands; every opcode matches exactly one row
// (static_assert below). A register field never means M, the byte HL points to: forms with M take other machine cycles and
// have separate rows. The twelve opcodes that Intel left undefined repeat others, with the same length, time and bus
// cycles; `duplicate` marks them: a disassembler cannot write them as the instruction and get the same byte back.
//
// Sources: Intel = MCS-80 User's Manual (1977), chapter 4, and its table of machine cycles; measured = the same bus cycles
// found on a gate-level model of the KR580VM80A, which covers the opcodes that the manual leaves out.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace sightline::i8080 {

enum class Operation : std::uint8_t {
  nop, lxi, stax, ldax, inx, dcx, inr, dcr, mvi, mov, hlt, dad, shld, lhld, sta, lda,
  rlc, rrc, ral, rar, daa, cma, stc, cmc,
  add, adc, sub, sbb, ana, xra, ora, cmp,  // register, M and immediate alike; in the order of the opcode's bits 5-3
  ret, jmp, call, conditional_return, conditional_jump, conditional_call,
  rst, push, pop, xthl, sphl, pchl, xchg, in, out, ei, di,
};

// The contents of the operand column. The operands up to `restart` are in the opcode; the others follow it.
enum class Operand : std::uint8_t {
  none,
  to_register,    // bits 5-3: B C D E H L - A; 6 would be M, which has its own row
  from_register,  // bits 2-0, likewise
  memory,         // M, written out; no bits
  pair,           // bits 5-4: B D H SP
  pair_b_d,       // bit 4: B D
  pair_psw,       // bits 5-4: B D H PSW
  restart,        // bits 5-3: 0 to 7
  data8,          // one byte follows
  port,           // one byte follows
  data16,         // two bytes follow, low first
  address,        // two bytes follow, low first
};

[[nodiscard]] constexpr int bytes_following(Operand operand) {
  if (operand == Operand::data8 || operand == Operand::port) return 1;
  return operand == Operand::data16 || operand == Operand::address ? 2 : 0;
}

// Machine cycles. The fetch has 4 or 5 T-states, the last stack write of XTHL 5, all others 3.
enum class CycleKind : std::uint8_t {
  fetch, read, write, stack_read, stack_write, input, output, halt,
  internal,  // no SYNC, nothing on the bus: DAD
};

struct MachineCycle {
  CycleKind kind;
  std::uint8_t t_states;
  friend constexpr bool operator==(MachineCycle, MachineCycle) = default;
};

// The machine cycles of one instruction, in order.
class Cycles {
 public:
  // The text has the notation of common instruction tables, "F4 R3 R3": F fetch, R W memory, r w stack, I O port, H halt, x
  // internal, each with its T-states. Any other text does not compile.
  consteval explicit Cycles(std::string_view text) {
    for (std::size_t i = 0; i + 1 < text.size(); i += 3) {
      cycles_[count_++] = {kind_of(text[i]), static_cast<std::uint8_t>(text[i + 1] - '0')};
    }
  }

  [[nodiscard]] constexpr std::size_t size() const { return count_; }
  [[nodiscard]] constexpr MachineCycle operator[](std::size_t i) const { return cycles_[i]; }
  [[nodiscard]] constexpr const MachineCycle* begin() const { return cycles_.data(); }
  [[nodiscard]] constexpr const MachineCycle* end() const { return cycles_.data() + count_; }
  [[nodiscard]] constexpr int t_states() const {
    int sum = 0;
    for (const MachineCycle& cycle : *this) sum += cycle.t_states;
    return sum;
  }
  friend constexpr bool operator==(const Cycles&, const Cycles&) = default;

 private:
  static consteval CycleKind kind_of(char letter) {
    constexpr std::string_view letters = "FRWrwIOHx";
    std::size_t kind = 0;
    while (letters[kind] != letter) ++kind;  // another letter does not compile
    return static_cast<CycleKind>(kind);
  }

  std::array<MachineCycle, 5> cycles_{};
  std::size_t count_ = 0;
};

// Bits of F, the low byte of the PSW. Bit 1 always reads 1; bits 3 and 5 always read 0.
namespace flag {
inline constexpr std::uint8_t sign = 0x80;
inline constexpr std::uint8_t zero = 0x40;
inline constexpr std::uint8_t auxiliary = 0x10;
inline constexpr std::uint8_t parity = 0x04;
inline constexpr std::uint8_t carry = 0x01;
inline constexpr std::uint8_t always_one = 0x02;
inline constexpr std::uint8_t all = sign | zero | auxiliary | parity | carry;
}  // namespace flag

struct Instruction {
  std::uint8_t mask;
  std::uint8_t value;
  std::string_view mnemonic;  // lower case
  Operation operation;
  std::array<Operand, 2> operands;
  Cycles cycles;      // conditional forms: the condition is false
  Cycles taken;       // the condition is true; all others: as `cycles`
  std::uint8_t flags;  // flags that it can change; POP changes them for PSW only
  bool duplicate = false;

  // Length in bytes, 1 to 3.
  [[nodiscard]] constexpr int bytes() const {
    return 1 + bytes_following(operands[0]) + bytes_following(operands[1]);
  }
  [[nodiscard]] constexpr bool conditional() const {
    return operation == Operation::conditional_return || operation == Operation::conditional_jump ||
           operation == Operation::conditional_call;
  }
  [[nodiscard]] constexpr std::string_view source() const { return duplicate ? "measured" : "Intel"; }
  [[nodiscard]] constexpr bool matches(std::uint8_t opcode) const {
    if ((opcode & mask) != value) return false;
    for (const Operand operand : operands) {
      if (operand == Operand::to_register && (opcode >> 3 & 7) == 6) return false;
      if (operand == Operand::from_register && (opcode & 7) == 6) return false;
    }
    return true;
  }
};

namespace detail {

using enum Operand;
using O = Operation;

inline constexpr std::uint8_t all_but_carry = flag::all & ~flag::carry;

consteval Instruction row(std::uint8_t mask, std::uint8_t value, std::string_view mnemonic, Operation operation,
                          std::array<Operand, 2> operands, std::string_view cycles, std::uint8_t flags = 0) {
  return {mask, value, mnemonic, operation, operands, Cycles(cycles), Cycles(cycles), flags};
}

consteval Instruction conditional(std::uint8_t value, std::string_view mnemonic, Operation operation, Operand target,
                                  std::string_view cycles, std::string_view taken) {
  return {0xFF, value, mnemonic, operation, {target, none}, Cycles(cycles), Cycles(taken), 0};
}

consteval Instruction duplicate(std::uint8_t mask, std::uint8_t value, std::string_view mnemonic,
                                Operation operation, Operand target, std::string_view cycles) {
  return {mask, value, mnemonic, operation, {target, none}, Cycles(cycles), Cycles(cycles), 0, true};
}

consteval Instruction returns(std::uint8_t value, std::string_view mnemonic) {
  return conditional(value, mnemonic, O::conditional_return, none, "F5", "F5 r3 r3");
}
consteval Instruction jumps(std::uint8_t value, std::string_view mnemonic) {
  return row(0xFF, value, mnemonic, O::conditional_jump, {address, none}, "F4 R3 R3");
}
consteval Instruction calls(std::uint8_t value, std::string_view mnemonic) {
  return conditional(value, mnemonic, O::conditional_call, address, "F5 R3 R3", "F5 R3 R3 w3 w3");
}

// One arithmetic or logical operation in its three forms.
consteval Instruction with_register(std::uint8_t value, std::string_view mnemonic, Operation operation) {
  return row(0xF8, value, mnemonic, operation, {from_register, none}, "F4", flag::all);
}
consteval Instruction with_memory(std::uint8_t value, std::string_view mnemonic, Operation operation) {
  return row(0xFF, value, mnemonic, operation, {memory, none}, "F4 R3", flag::all);
}
consteval Instruction with_data(std::uint8_t value, std::string_view mnemonic, Operation operation) {
  return row(0xFF, value, mnemonic, operation, {data8, none}, "F4 R3", flag::all);
}

consteval auto make_instructions() {
  return std::array{
      row(0xFF, 0x00, "nop", O::nop, {none, none}, "F4"),
      row(0xCF, 0x01, "lxi", O::lxi, {pair, data16}, "F4 R3 R3"),
      row(0xEF, 0x02, "stax", O::stax, {pair_b_d, none}, "F4 W3"),
      row(0xEF, 0x0A, "ldax", O::ldax, {pair_b_d, none}, "F4 R3"),
      row(0xCF, 0x03, "inx", O::inx, {pair, none}, "F5"),
      row(0xCF, 0x0B, "dcx", O::dcx, {pair, none}, "F5"),
      row(0xC7, 0x04, "inr", O::inr, {to_register, none}, "F5", all_but_carry),
      row(0xFF, 0x34, "inr", O::inr, {memory, none}, "F4 R3 W3", all_but_carry),
      row(0xC7, 0x05, "dcr", O::dcr, {to_register, none}, "F5", all_but_carry),
      row(0xFF, 0x35, "dcr", O::dcr, {memory, none}, "F4 R3 W3", all_but_carry),
      row(0xC7, 0x06, "mvi", O::mvi, {to_register, data8}, "F4 R3"),
      row(0xFF, 0x36, "mvi", O::mvi, {memory, data8}, "F4 R3 W3"),
      row(0xC0, 0x40, "mov", O::mov, {to_register, from_register}, "F5"),
      row(0xC7, 0x46, "mov", O::mov, {to_register, memory}, "F4 R3"),
      row(0xF8, 0x70, "mov", O::mov, {memory, from_register}, "F4 W3"),
      row(0xFF, 0x76, "hlt", O::hlt, {none, none}, "F4 H3"),
      row(0xCF, 0x09, "dad", O::dad, {pair, none}, "F4 x3 x3", flag::carry),
      row(0xFF, 0x22, "shld", O::shld, {address, none}, "F4 R3 R3 W3 W3"),
      row(0xFF, 0x2A, "lhld", O::lhld, {address, none}, "F4 R3 R3 R3 R3"),
      row(0xFF, 0x32, "sta", O::sta, {address, none}, "F4 R3 R3 W3"),
      row(0xFF, 0x3A, "lda", O::lda, {address, none}, "F4 R3 R3 R3"),
      row(0xFF, 0x07, "rlc", O::rlc, {none, none}, "F4", flag::carry),
      row(0xFF, 0x0F, "rrc", O::rrc, {none, none}, "F4", flag::carry),
      row(0xFF, 0x17, "ral", O::ral, {none, none}, "F4", flag::carry),
      row(0xFF, 0x1F, "rar", O::rar, {none, none}, "F4", flag::carry),
      row(0xFF, 0x27, "daa", O::daa, {none, none}, "F4", flag::all),
      row(0xFF, 0x2F, "cma", O::cma, {none, none}, "F4"),
      row(0xFF, 0x37, "stc", O::stc, {none, none}, "F4", flag::carry),
      row(0xFF, 0x3F, "cmc", O::cmc, {none, none}, "F4", flag::carry),
      with_register(0x80, "add", O::add), with_memory(0x86, "add", O::add), with_data(0xC6, "adi", O::add),
      with_register(0x88, "adc", O::adc), with_memory(0x8E, "adc", O::adc), with_data(0xCE, "aci", O::adc),
      with_register(0x90, "sub", O::sub), with_memory(0x96, "sub", O::sub), with_data(0xD6, "sui", O::sub),
      with_register(0x98, "sbb", O::sbb), with_memory(0x9E, "sbb", O::sbb), with_data(0xDE, "sbi", O::sbb),
      with_register(0xA0, "ana", O::ana), with_memory(0xA6, "ana", O::ana), with_data(0xE6, "ani", O::ana),
      with_register(0xA8, "xra", O::xra), with_memory(0xAE, "xra", O::xra), with_data(0xEE, "xri", O::xra),
      with_register(0xB0, "ora", O::ora), with_memory(0xB6, "ora", O::ora), with_data(0xF6, "ori", O::ora),
      with_register(0xB8, "cmp", O::cmp), with_memory(0xBE, "cmp", O::cmp), with_data(0xFE, "cpi", O::cmp),
      row(0xFF, 0xC9, "ret", O::ret, {none, none}, "F4 r3 r3"),
      row(0xFF, 0xC3, "jmp", O::jmp, {address, none}, "F4 R3 R3"),
      row(0xFF, 0xCD, "call", O::call, {address, none}, "F5 R3 R3 w3 w3"),
      returns(0xC0, "rnz"), returns(0xC8, "rz"), returns(0xD0, "rnc"), returns(0xD8, "rc"),
      returns(0xE0, "rpo"), returns(0xE8, "rpe"), returns(0xF0, "rp"), returns(0xF8, "rm"),
      jumps(0xC2, "jnz"), jumps(0xCA, "jz"), jumps(0xD2, "jnc"), jumps(0xDA, "jc"),
      jumps(0xE2, "jpo"), jumps(0xEA, "jpe"), jumps(0xF2, "jp"), jumps(0xFA, "jm"),
      calls(0xC4, "cnz"), calls(0xCC, "cz"), calls(0xD4, "cnc"), calls(0xDC, "cc"),
      calls(0xE4, "cpo"), calls(0xEC, "cpe"), calls(0xF4, "cp"), calls(0xFC, "cm"),
      row(0xC7, 0xC7, "rst", O::rst, {restart, none}, "F5 w3 w3"),
      row(0xCF, 0xC5, "push", O::push, {pair_psw, none}, "F5 w3 w3"),
      row(0xCF, 0xC1, "pop", O::pop, {pair_psw, none}, "F4 r3 r3", flag::all),
      row(0xFF, 0xE3, "xthl", O::xthl, {none, none}, "F4 r3 r3 w3 w5"),
      row(0xFF, 0xF9, "sphl", O::sphl, {none, none}, "F5"),
      row(0xFF, 0xE9, "pchl", O::pchl, {none, none}, "F5"),
      row(0xFF, 0xEB, "xchg", O::xchg, {none, none}, "F4"),
      row(0xFF, 0xDB, "in", O::in, {port, none}, "F4 R3 I3"),
      row(0xFF, 0xD3, "out", O::out, {port, none}, "F4 R3 O3"),
      row(0xFF, 0xFB, "ei", O::ei, {none, none}, "F4"),
      row(0xFF, 0xF3, "di", O::di, {none, none}, "F4"),
      duplicate(0xFF, 0x08, "nop", O::nop, none, "F4"),
      duplicate(0xF7, 0x10, "nop", O::nop, none, "F4"),
      duplicate(0xE7, 0x20, "nop", O::nop, none, "F4"),
      duplicate(0xFF, 0xCB, "jmp", O::jmp, address, "F4 R3 R3"),
      duplicate(0xFF, 0xD9, "ret", O::ret, none, "F4 r3 r3"),
      duplicate(0xDF, 0xDD, "call", O::call, address, "F5 R3 R3 w3 w3"),
      duplicate(0xFF, 0xED, "call", O::call, address, "F5 R3 R3 w3 w3"),
  };
}

}  // namespace detail

inline constexpr auto instructions = detail::make_instructions();

namespace detail {

consteval bool every_opcode_matches_one_row() {
  for (int opcode = 0; opcode < 256; ++opcode) {
    int rows = 0;
    for (const Instruction& row : instructions) rows += row.matches(static_cast<std::uint8_t>(opcode)) ? 1 : 0;
    if (rows != 1) return false;
  }
  return true;
}

consteval auto make_row_table() {
  std::array<std::uint8_t, 256> table{};
  for (std::size_t opcode = 0; opcode < 256; ++opcode) {
    for (std::size_t r = 0; r < instructions.size(); ++r) {
      if (instructions[r].matches(static_cast<std::uint8_t>(opcode))) table[opcode] = static_cast<std::uint8_t>(r);
    }
  }
  return table;
}

inline constexpr auto row_table = make_row_table();

}  // namespace detail

static_assert(detail::every_opcode_matches_one_row());

// The row of an opcode.
[[nodiscard]] constexpr const Instruction& lookup(std::uint8_t opcode) {
  return instructions[detail::row_table[opcode]];
}

// Names of the fields, in the order of their codes.
inline constexpr std::array<std::string_view, 8> register_names{"b", "c", "d", "e", "h", "l", "m", "a"};
inline constexpr std::array<std::string_view, 4> pair_names{"b", "d", "h", "sp"};
inline constexpr std::array<std::string_view, 4> psw_pair_names{"b", "d", "h", "psw"};
inline constexpr std::array<std::string_view, 8> condition_names{"nz", "z", "nc", "c", "po", "pe", "p", "m"};

}  // namespace sightline::i8080
