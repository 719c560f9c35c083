// The PDP-7 instruction set: one table that the CPU, the assembler, the disassembler and the trace read.
//
// `instructions` has one row for every pattern that the machine decodes; every 18-bit word matches exactly one row
// (static_assert below). `microinstructions` names single words and bits inside the augmented classes (EAE, IOT, OPR) and
// adds no meaning. A device's file names its IOTs (IotDeviceInfo::iots). Cycles are machine cycles of 1.75 us for the
// direct form; an indirect reference adds one Defer cycle, auto-index none. Time beyond whole cycles (EAE stepping, slow
// IOT cycles) is in timing.hpp.
//
// Sources: P4 = "Programmed Data Processor-4 Manual" (DEC 1962), with which the PDP-7 is program compatible, printed
// page; EAE = Type 177 instruction list, confirmed by three independent symbol tables.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace sightline::pdp7 {

enum class Operation : std::uint8_t {
  cal, dac, jms, dzm, lac, xor_, add, tad, xct, isz, and_, sad, jmp,
  eae_setup, eae_multiply, eae_unused, eae_divide, eae_normalize, eae_long_right, eae_long_left, eae_ac_left,
  iot, opr, law,
};

enum class Operands : std::uint8_t {
  none,       // CAL: the address field is ignored
  address,    // bit 4 indirect, bits 5-17 address
  steps,      // EAE: bits 12-17 step count, bits 4-8 options
  microcode,  // every bit has a meaning
  immediate,  // LAW: the word itself
};

// How two terms of an expression with a space between them combine in the assembler: OR inside one class, otherwise a sum.
enum class Class : std::uint8_t { memory, eae, iot, opr, law };

struct Instruction {
  std::uint32_t mask;
  std::uint32_t value;
  std::string_view mnemonic;  // lower case, as the assembler lists it
  Operation operation;
  Operands operands;
  Class instruction_class;
  int cycles;                 // direct form, without asynchronous EAE time; xct: its own fetch only
  std::string_view source;
};

inline constexpr std::array instructions{
    Instruction{0740000, 0000000, "cal", Operation::cal, Operands::none, Class::memory, 2, "P4-20"},
    Instruction{0740000, 0040000, "dac", Operation::dac, Operands::address, Class::memory, 2, "P4-57"},
    Instruction{0740000, 0100000, "jms", Operation::jms, Operands::address, Class::memory, 2, "P4-20"},
    Instruction{0740000, 0140000, "dzm", Operation::dzm, Operands::address, Class::memory, 2, "P4-57"},
    Instruction{0740000, 0200000, "lac", Operation::lac, Operands::address, Class::memory, 2, "P4-57"},
    Instruction{0740000, 0240000, "xor", Operation::xor_, Operands::address, Class::memory, 2, "P4-57"},
    Instruction{0740000, 0300000, "add", Operation::add, Operands::address, Class::memory, 2, "P4-17"},
    Instruction{0740000, 0340000, "tad", Operation::tad, Operands::address, Class::memory, 2, "P4-18"},
    Instruction{0740000, 0400000, "xct", Operation::xct, Operands::address, Class::memory, 1, "P4-20"},
    Instruction{0740000, 0440000, "isz", Operation::isz, Operands::address, Class::memory, 2, "P4-57"},
    Instruction{0740000, 0500000, "and", Operation::and_, Operands::address, Class::memory, 2, "P4-57"},
    Instruction{0740000, 0540000, "sad", Operation::sad, Operands::address, Class::memory, 2, "P4-57"},
    Instruction{0740000, 0600000, "jmp", Operation::jmp, Operands::address, Class::memory, 1, "P4-57"},
    Instruction{0740700, 0640000, "eae", Operation::eae_setup, Operands::microcode, Class::eae, 1, "EAE"},
    Instruction{0740700, 0640100, "mul", Operation::eae_multiply, Operands::steps, Class::eae, 2, "EAE"},
    Instruction{0740700, 0640200, "eae2", Operation::eae_unused, Operands::steps, Class::eae, 1, "EAE"},
    Instruction{0740700, 0640300, "div", Operation::eae_divide, Operands::steps, Class::eae, 2, "EAE"},
    Instruction{0740700, 0640400, "norm", Operation::eae_normalize, Operands::steps, Class::eae, 1, "EAE"},
    Instruction{0740700, 0640500, "lrs", Operation::eae_long_right, Operands::steps, Class::eae, 1, "EAE"},
    Instruction{0740700, 0640600, "lls", Operation::eae_long_left, Operands::steps, Class::eae, 1, "EAE"},
    Instruction{0740700, 0640700, "als", Operation::eae_ac_left, Operands::steps, Class::eae, 1, "EAE"},
    Instruction{0740000, 0700000, "iot", Operation::iot, Operands::microcode, Class::iot, 1, "P4-23"},
    Instruction{0760000, 0740000, "opr", Operation::opr, Operands::microcode, Class::opr, 1, "P4-58"},
    Instruction{0760000, 0760000, "law", Operation::law, Operands::immediate, Class::law, 1, "P4-23"},
};

namespace detail {

// Every row's mask lies in bits 0-4 and 9-11: index by those eight bits.
[[nodiscard]] constexpr std::size_t decode_index(std::uint32_t word) {
  return ((word >> 13) & 037U) << 3 | ((word >> 6) & 07U);
}

[[nodiscard]] constexpr int rows_matching(std::uint32_t word) {
  int n = 0;
  for (const auto& row : instructions) n += (word & row.mask) == row.value ? 1 : 0;
  return n;
}

[[nodiscard]] constexpr bool every_word_matches_one_row() {
  for (std::uint32_t i = 0; i < 256; ++i) {
    if (rows_matching((i >> 3) << 13 | (i & 07U) << 6) != 1) return false;
  }
  return true;
}

[[nodiscard]] constexpr bool masks_lie_in_the_index() {
  for (const auto& row : instructions) {
    if ((row.mask & ~std::uint32_t{0760700}) != 0) return false;
  }
  return true;
}

[[nodiscard]] constexpr auto make_row_table() {
  std::array<std::uint8_t, 256> table{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    for (std::size_t r = 0; r < instructions.size(); ++r) {
      const std::uint32_t word = (i >> 3) << 13 | (i & 07U) << 6;
      if ((word & instructions[r].mask) == instructions[r].value) table[i] = static_cast<std::uint8_t>(r);
    }
  }
  return table;
}

inline constexpr auto row_table = make_row_table();

}  // namespace detail

static_assert(detail::masks_lie_in_the_index());
static_assert(detail::every_word_matches_one_row());

// The row of an 18-bit word.
[[nodiscard]] constexpr const Instruction& instruction_of(std::uint32_t word) {
  return instructions[detail::row_table[detail::decode_index(word)]];
}

// The processor's names inside the augmented classes. `name` is a permanent symbol of the assembler.
struct Microinstruction {
  std::string_view name;
  std::uint32_t value;
  std::string_view meaning;
};

inline constexpr std::array microinstructions{
    // OPR (P4-58). Order of events: skip test; CLA, CLL; CMA, CML, OAS, rotate; HLT.
    Microinstruction{"nop", 0740000, "no operation"},
    Microinstruction{"cma", 0740001, "complement AC"},
    Microinstruction{"cml", 0740002, "complement L"},
    Microinstruction{"oas", 0740004, "OR AC switches into AC"},
    Microinstruction{"ral", 0740010, "rotate L,AC left"},
    Microinstruction{"rar", 0740020, "rotate L,AC right"},
    Microinstruction{"hlt", 0740040, "halt"},
    Microinstruction{"xx", 0740040, "halt"},
    Microinstruction{"sma", 0740100, "skip if AC negative"},
    Microinstruction{"sza", 0740200, "skip if AC is +0"},
    Microinstruction{"snl", 0740400, "skip if L is 1"},
    Microinstruction{"skp", 0741000, "skip"},
    Microinstruction{"spa", 0741100, "skip if AC positive"},
    Microinstruction{"sna", 0741200, "skip if AC is not +0"},
    Microinstruction{"szl", 0741400, "skip if L is 0"},
    Microinstruction{"rtl", 0742010, "rotate L,AC left twice"},
    Microinstruction{"rtr", 0742020, "rotate L,AC right twice"},
    Microinstruction{"cll", 0744000, "clear L"},
    Microinstruction{"stl", 0744002, "set L"},
    Microinstruction{"rcl", 0744010, "clear L, rotate left"},
    Microinstruction{"rcr", 0744020, "clear L, rotate right"},
    Microinstruction{"cla", 0750000, "clear AC"},
    Microinstruction{"clc", 0750001, "AC to all ones"},
    Microinstruction{"las", 0750004, "AC from AC switches"},
    Microinstruction{"glk", 0750010, "AC from L"},
    // LAW
    Microinstruction{"lam", 0777777, "AC to minus one"},
    // EAE (Type 177). Bits 12-17 of those with a count are the step count.
    Microinstruction{"osc", 0640001, "OR step counter into AC"},
    Microinstruction{"omq", 0640002, "OR MQ into AC"},
    Microinstruction{"cmq", 0640004, "complement MQ"},
    Microinstruction{"lacs", 0641001, "AC from step counter"},
    Microinstruction{"lacq", 0641002, "AC from MQ"},
    Microinstruction{"ecla", 0641000, "clear AC"},
    Microinstruction{"abs", 0644000, "absolute value of AC"},
    Microinstruction{"gsm", 0664000, "sign of AC to L, absolute value"},
    Microinstruction{"clq", 0650000, "clear MQ"},
    Microinstruction{"lmq", 0652000, "MQ from AC"},
    Microinstruction{"mul", 0653122, "multiply, unsigned"},
    Microinstruction{"muls", 0657122, "multiply, signed"},
    Microinstruction{"div", 0640323, "divide, unsigned"},
    Microinstruction{"divs", 0644323, "divide, signed"},
    Microinstruction{"idiv", 0653323, "integer divide, unsigned"},
    Microinstruction{"idivs", 0657323, "integer divide, signed"},
    Microinstruction{"frdiv", 0650323, "fraction divide, unsigned"},
    Microinstruction{"frdivs", 0654323, "fraction divide, signed"},
    Microinstruction{"norm", 0640444, "normalize"},
    Microinstruction{"norms", 0660444, "normalize, signed"},
    Microinstruction{"lrs", 0640500, "long right shift"},
    Microinstruction{"lrss", 0660500, "long right shift, signed"},
    Microinstruction{"lls", 0640600, "long left shift"},
    Microinstruction{"llss", 0660600, "long left shift, signed"},
    Microinstruction{"als", 0640700, "AC left shift"},
    Microinstruction{"alss", 0660700, "AC left shift, signed"},
    // IOT: interrupt system and console
    Microinstruction{"iof", 0700002, "interrupts off"},
    Microinstruction{"ion", 0700042, "interrupts on after the next instruction"},
    Microinstruction{"iton", 0700062, "interrupts and trap mode on"},
    Microinstruction{"caf", 0703302, "clear all flags"},
    Microinstruction{"tts", 0703301, "skip if the teletype is installed"},
    Microinstruction{"skp7", 0703341, "skip if this is a PDP-7"},
    Microinstruction{"iors", 0700314, "read flags"},
    // IOT: extend mode (Type 148)
    Microinstruction{"sem", 0707701, "skip if extend mode"},
    Microinstruction{"eem", 0707702, "extend mode on"},
    Microinstruction{"emir", 0707742, "extend mode on, next JMP I restores"},
    Microinstruction{"lem", 0707704, "extend mode off"},
};

// Bit 4, the indirect bit; in the assembler the symbol `i`.
inline constexpr std::uint32_t indirect_bit = 0020000;

}  // namespace sightline::pdp7
