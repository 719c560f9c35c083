// Values of PDP-7 expressions: 18-bit arithmetic, and the combination of an instruction with its operand.
//
// A value keeps the instruction part (head) and the number added to it (operand) apart until the expression is complete:
// only then is it known whether the operand fits the field of the instruction.
#pragma once

#include <cstdint>

#include "tools/asm/engine.hpp"

namespace sightline::assembler {

enum class Form : std::uint8_t {
  plain,     // a number: operand only
  indirect,  // the symbol i alone: operand 20000
  memory,    // opcode and indirect bit in head; 13-bit address
  law,       // 760000 in head; 13-bit number
  micro,     // EAE, IOT, OPR: ORed together
};

struct Value {
  std::uint32_t head = 0;
  std::uint32_t operand = 0;
  Form form = Form::plain;
  bool known = true;
  bool bare_number = false;  // written as an unsigned number, which may be a microinstruction

  [[nodiscard]] static Value number(std::uint32_t n) { return Value{0, n, Form::plain, true, false}; }
  [[nodiscard]] static Value unknown() { return Value{0, 0, Form::plain, false, false}; }
};

// Tells the engine what is wrong with an expression at `at`.
class Arithmetic {
 public:
  Arithmetic(bool twos_complement, Engine& engine) : twos_complement_(twos_complement), engine_(engine) {}

  [[nodiscard]] Value combine(Value left, Value right, const Position& at) const;  // space and +
  [[nodiscard]] Value difference(const Value& left, const Value& right) const;
  [[nodiscard]] Value logical(Value left, const Value& right, bool conjunction) const;
  [[nodiscard]] Value negative(const Value& value) const;
  // The 18-bit word; checks the operand against its field. location: the address of the word, which selects its bank.
  [[nodiscard]] std::uint32_t word(const Value& value, std::uint32_t location, const Position& at) const;

 private:
  [[nodiscard]] std::uint32_t add(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] std::uint32_t negate(std::uint32_t a) const;
  [[nodiscard]] std::uint32_t subtract(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] std::uint32_t sum(const Value& value) const { return add(value.head, value.operand); }
  void warn_about_opr(std::uint32_t a, std::uint32_t b, const Position& at) const;
  [[nodiscard]] std::uint32_t address_field(const Value& value, std::uint32_t operand, std::uint32_t location, const Position& at) const;

  bool twos_complement_;
  Engine& engine_;
};

// The form of a word that is defined as an instruction, and the split of that word into head and operand.
[[nodiscard]] Form form_of_instruction(std::uint32_t word);
[[nodiscard]] Value from_symbol(std::uint32_t word, Form form);

}  // namespace sightline::assembler
