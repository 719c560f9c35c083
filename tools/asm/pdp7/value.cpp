#include "tools/asm/pdp7/value.hpp"

#include "emulators/core/word.hpp"
#include "emulators/pdp7/isa.hpp"
#include "host/base/number.hpp"
#include "tools/image/core_image.hpp"

namespace sightline::assembler {
namespace {

using base::octal;
using image::bank_mask;
using image::field_mask;

constexpr std::uint32_t step_count_mask = 077;
constexpr std::uint32_t skip_conditions = 0000700;
constexpr std::uint32_t skip_inverted = 0001000;
constexpr std::uint32_t rotates = 0000030;

pdp7::Class class_of(std::uint32_t word) {
  return pdp7::instruction_of(word).instruction_class;
}

bool same_class(std::uint32_t a, std::uint32_t b) {
  return class_of(a) == class_of(b);
}

bool microcode_class(std::uint32_t word) {
  const pdp7::Class c = class_of(word);
  return c == pdp7::Class::eae || c == pdp7::Class::iot || c == pdp7::Class::opr;
}

}  // namespace

Form form_of_instruction(std::uint32_t word) {
  switch (class_of(word)) {
    case pdp7::Class::memory: return Form::memory;
    case pdp7::Class::law: return (word & field_mask) == 0 ? Form::law : Form::plain;
    default: return Form::micro;
  }
}

Value from_symbol(std::uint32_t word, Form form) {
  switch (form) {
    case Form::memory:
    case Form::law: return Value{word & ~field_mask, word & field_mask, form, true, false};
    case Form::micro: return Value{word, 0, form, true, false};
    default: return Value{0, word, form, true, false};
  }
}

std::uint32_t Arithmetic::add(std::uint32_t a, std::uint32_t b) const {
  const std::uint32_t total = a + b;
  return (twos_complement_ || total <= core::Word18::mask ? total : total + 1) & core::Word18::mask;  // end-around carry
}

std::uint32_t Arithmetic::negate(std::uint32_t a) const {
  return (~a + (twos_complement_ ? 1U : 0U)) & core::Word18::mask;
}

std::uint32_t Arithmetic::subtract(std::uint32_t a, std::uint32_t b) const {
  return a == b ? 0 : add(a, negate(b));
}

// Combinations of OPR bits that assemble but do not act as their names say.
void Arithmetic::warn_about_opr(std::uint32_t a, std::uint32_t b, const Position& at) const {
  if (class_of(a) != pdp7::Class::opr) return;
  constexpr std::uint32_t skip = skip_conditions | skip_inverted;
  const bool both_skip = (a & skip) != 0 && (b & skip) != 0;
  if (both_skip && ((a ^ b) & skip_inverted) != 0) {
    engine_.warning(at, "skips of opposite sense in one word",
                    "sma sza snl together or spa sna szl together (bit 1000 inverts all of them)");
  }
  if (((a | b) & rotates) == rotates && (a & rotates) != rotates && (b & rotates) != rotates) {
    engine_.warning(at, "left and right rotate in one word", "one of them");
  }
}

Value Arithmetic::combine(Value left, Value right, const Position& at) const {
  const bool known = left.known && right.known;
  const auto is_instruction = [](const Value& v) { return v.form >= Form::memory; };
  if (!is_instruction(left) && is_instruction(right)) std::swap(left, right);
  if (left.form == Form::micro && right.bare_number && microcode_class(right.operand) &&
      same_class(left.head, right.operand)) {
    right = from_symbol(right.operand, Form::micro);
  }
  Value result = left;
  result.known = known;
  result.bare_number = false;
  if (!is_instruction(left)) {
    result.form = Form::plain;
    result.operand = add(left.operand, right.operand);
  } else if (left.form == Form::memory && right.form == Form::indirect) {
    if ((left.head & pdp7::indirect_bit) != 0)
      engine_.error(at, "a second i", "one in a word");
    result.head |= pdp7::indirect_bit;
  } else if (!is_instruction(right)) {
    result.operand = add(left.operand, right.operand);
  } else if (left.form == Form::micro && right.form == Form::micro && same_class(left.head, right.head)) {
    warn_about_opr(left.head, right.head, at);
    result.head |= right.head;
    result.operand = add(left.operand, right.operand);
  } else if (known) {
    engine_.warning(at, "two instructions of different classes in one word, which are added",
                    "one instruction, or microinstructions of one class");
    result = Value::number(add(sum(left), sum(right)));
  }
  return result;
}

Value Arithmetic::difference(const Value& left, const Value& right) const {
  Value result = left;
  if (right.form >= Form::memory || left.form <= Form::indirect) {
    result = Value::number(subtract(sum(left), sum(right)));
  } else {
    result.operand = subtract(left.operand, right.operand);
  }
  result.known = left.known && right.known;
  result.bare_number = false;
  return result;
}

Value Arithmetic::logical(Value left, const Value& right, bool conjunction) const {
  const bool known = left.known && right.known;
  if (!conjunction && left.form == Form::memory && right.form == Form::indirect) {
    left.head |= pdp7::indirect_bit;
    left.known = known;
    return left;
  }
  if (left.form == Form::micro && right.form == Form::micro && same_class(left.head, right.head) &&
      left.operand == 0 && right.operand == 0 && !conjunction) {
    return Value{left.head | right.head, 0, Form::micro, known, false};
  }
  Value result = Value::number(conjunction ? sum(left) & sum(right) : sum(left) | sum(right));
  result.known = known;
  return result;
}

Value Arithmetic::negative(const Value& value) const {
  Value result = Value::number(negate(sum(value)));
  result.known = value.known;
  return result;
}

std::uint32_t Arithmetic::address_field(const Value& value, std::uint32_t operand, std::uint32_t location,
                                        const Position& at) const {
  const std::uint32_t bank = location & bank_mask;
  const bool ignored = pdp7::instruction_of(value.head).operands == pdp7::Operands::none;  // CAL
  if (operand > field_mask && (operand > image::last_address || (operand & bank_mask) != bank)) {
    engine_.error(at, "address " + octal(operand, 6),
                  "one from " + octal(bank, 5) + " to " + octal(bank | field_mask, 5));
  } else if (operand <= field_mask && bank != 0 && !ignored) {
    engine_.warning(at, "address " + octal(operand, 5) + " in a word of another bank",
                    octal(bank | operand, 5) + ", which is what the machine will use");
  }
  return operand & field_mask;
}

std::uint32_t Arithmetic::word(const Value& value, std::uint32_t location,
                               const Position& at) const {
  if (!value.known) return 0;
  const std::uint32_t operand =
      value.operand == core::Word18::mask && !twos_complement_ ? 0 : value.operand;  // -0 adds nothing
  switch (value.form) {
    case Form::memory: return value.head | address_field(value, operand, location, at);
    case Form::law:
      if (operand > field_mask) {
        engine_.error(at, "LAW " + octal(operand, 6), "a number from 0 to 17777");
      }
      return value.head | (operand & field_mask);
    case Form::micro: {
      const std::uint32_t result = add(value.head, operand);
      const auto& row = pdp7::instruction_of(value.head);
      const bool counted = row.operands == pdp7::Operands::steps;
      const bool fits = counted ? (result & ~step_count_mask) == (value.head & ~step_count_mask)
                                : same_class(result, value.head);
      if (!fits) {
        engine_.error(at, "operand " + octal(operand, 6),
                      counted ? "a step count that keeps bits 12-17 from 00 to 77"
                              : "one that leaves the word an " + std::string(row.mnemonic));
      }
      return result;
    }
    default: return value.operand;
  }
}

}  // namespace sightline::assembler
