// Instructions: the instruction table gives the operands of a mnemonic and the rows that they select.
#include <array>

#include "tools/asm/i8080/pass.hpp"

namespace sightline::assembler {
namespace {

using i8080::Instruction;
using i8080::Operand;

constexpr std::uint8_t code_of_m = 6;
// CP/M's ASM and MAC take PUSH A as PUSH PSW.
constexpr std::uint8_t code_of_a = 7;
constexpr std::uint8_t code_of_psw_pair = 3;

bool is_register(Operand operand) {
  return operand == Operand::to_register || operand == Operand::from_register || operand == Operand::memory;
}

bool is_pair(Operand operand) {
  return operand == Operand::pair || operand == Operand::pair_b_d || operand == Operand::pair_psw;
}

const char* expected_for(Operand operand) {
  switch (operand) {
    case Operand::pair: return "a register pair B D H SP";
    case Operand::pair_b_d: return "register pair B or D";
    case Operand::pair_psw: return "a register pair B D H PSW";
    case Operand::restart: return "a restart number 0 to 7";
    default: return "a register B C D E H L M A";
  }
}

// Bits of the opcode for the code of an operand.
std::uint8_t opcode_bits(Operand operand, std::uint8_t code) {
  switch (operand) {
    case Operand::to_register:
    case Operand::restart: return static_cast<std::uint8_t>(code << 3);
    case Operand::from_register: return code;
    case Operand::pair:
    case Operand::pair_b_d:
    case Operand::pair_psw: return static_cast<std::uint8_t>(code << 4);
    default: return 0;
  }
}

using Codes = std::array<std::uint8_t, 2>;

bool takes(const Instruction& row, const Codes& codes) {
  for (std::size_t i = 0; i < codes.size(); ++i) {
    if (is_register(row.operands[i]) && (row.operands[i] == Operand::memory) != (codes[i] == code_of_m))
      return false;
  }
  return true;
}

std::optional<std::uint8_t> opcode_of(const Mnemonic& rows, const Codes& codes) {
  for (const Instruction* const row : rows) {
    if (!takes(*row, codes)) continue;
    unsigned opcode = row->value;
    for (std::size_t i = 0; i < codes.size(); ++i) opcode |= opcode_bits(row->operands[i], codes[i]);
    return static_cast<std::uint8_t>(opcode);
  }
  return std::nullopt;
}

// SP, PSW and M all have code 6: only the name shows which was meant.
bool is_other_name(Operand operand, std::string_view name) {
  if (is_register(operand)) return name == "sp" || name == "psw";
  if (operand == Operand::pair) return name == "psw" || name == "m";
  if (operand == Operand::pair_psw) return name == "sp" || name == "m";
  return false;
}

std::optional<std::uint8_t> code_of_pair_name(std::string_view name) {
  if (name == "bc") return std::uint8_t{0};
  if (name == "de") return std::uint8_t{1};
  if (name == "hl") return std::uint8_t{2};
  return std::nullopt;
}

std::optional<std::uint8_t> code_of(Operand operand, std::uint32_t value) {
  if (!is_pair(operand)) return value < 8 ? std::optional(static_cast<std::uint8_t>(value)) : std::nullopt;
  if (operand == Operand::pair_psw && value == code_of_a) return code_of_psw_pair;
  const std::uint32_t most = operand == Operand::pair_b_d ? 2 : 6;
  if (value % 2 != 0 || value > most) return std::nullopt;
  return static_cast<std::uint8_t>(value / 2);
}

}  // namespace

// An operand that is part of the opcode.
std::optional<std::uint8_t> I8080Pass::field(Operand operand) {
  const I8080Token first = token_;
  const I8080Token after = I8080Lexer(lexer_).next();
  const bool alone = first.kind == I8080TokenKind::name &&
                     (after.kind == I8080TokenKind::end || after.is(',') || after.is(')'));
  if (at_end() || (alone && is_other_name(operand, first.value))) {
    unexpected(expected_for(operand));
    return std::nullopt;
  }
  if (alone && is_pair(operand) && engine_.find(first.value) == nullptr) {
    if (const auto code = code_of_pair_name(first.value)) {
      advance();
      return code;
    }
  }
  // The name means the register even if a label has the same name.
  const Word* const named = alone ? word(first.value, WordKind::register_name) : nullptr;
  std::optional<I8080Value> value;
  if (named != nullptr) {
    advance();
    value = I8080Value{named->value, true, false, false};
  } else {
    value = expression();
  }
  if (!value) return std::nullopt;
  const auto code = code_of(operand, value->bits);
  if (!code) error(first.column, quoted(first.text), expected_for(operand));
  return code;
}

void I8080Pass::instruction(const Mnemonic& rows) {
  const Instruction& form = *rows.front();
  Codes codes{};
  std::uint32_t data = 0;
  bool good = true;
  for (std::size_t i = 0; good && i < form.operands.size() && form.operands[i] != Operand::none; ++i) {
    if (i > 0) {
      good = expect_comma();
      if (!good) break;
    }
    const int size = i8080::bytes_following(form.operands[i]);
    if (size == 0) {
      const auto code = field(form.operands[i]);
      good = code.has_value();
      codes[i] = code.value_or(0);
      continue;
    }
    const std::size_t at = token_.column;
    const auto value = expression();
    good = value.has_value() && (size == 2 || byte_of(*value, at).has_value());
    if (good) data = value->bits;
  }
  good = good && expect_end();
  const auto opcode = opcode_of(rows, codes);
  if (good && !opcode) error(0, "both operands M", "a register for one of them");
  emit(opcode.value_or(0));
  for (int i = 1; i < form.bytes(); ++i, data >>= 8) emit(static_cast<std::uint8_t>(data));
}

// An instruction as a value: its opcode. Trailing operands that are part of the opcode may be omitted.
std::optional<std::uint8_t> I8080Pass::opcode_value(const Mnemonic& rows) {
  const std::size_t at = token_.column;
  const Instruction& form = *rows.front();
  if (!go_deeper()) return std::nullopt;
  advance();
  Codes codes{};
  for (std::size_t i = 0; i < form.operands.size(); ++i) {
    if (form.operands[i] == Operand::none || i8080::bytes_following(form.operands[i]) > 0) break;
    if (at_end() || token_.is(')') || (i == 0 && token_.is(','))) break;
    if (i > 0 && !token_.is(',')) break;
    if (i > 0) advance();
    const auto code = field(form.operands[i]);
    if (!code) return std::nullopt;
    codes[i] = *code;
  }
  --nesting_;
  const auto opcode = opcode_of(rows, codes);
  if (!opcode) error(at, "both operands M", "a register for one of them");
  return opcode;
}

}  // namespace sightline::assembler
