// Expressions, by Intel's precedence (8080/8085 Assembly Language Programming Manual, chapter 2): 16 bits, unsigned.
#include <algorithm>
#include <array>
#include <utility>

#include "tools/asm/i8080/pass.hpp"
#include "tools/image/binary.hpp"

namespace sightline::assembler {
namespace {

constexpr std::uint32_t word_mask = 0xFFFF;
constexpr int deepest_nesting = 100;

// Lowest precedence first. NOT is between AND and the relations and has one operand.
constexpr int not_level = 2;
constexpr int relation_level = 3;
constexpr int sum_level = 4;
constexpr int tightest_level = 5;

int precedence(Operator operation) {
  switch (operation) {
    case Operator::or_:
    case Operator::xor_: return 0;
    case Operator::and_: return 1;
    case Operator::eq:
    case Operator::ne:
    case Operator::lt:
    case Operator::le:
    case Operator::gt:
    case Operator::ge: return relation_level;
    case Operator::add:
    case Operator::subtract: return sum_level;
    case Operator::multiply:
    case Operator::divide:
    case Operator::mod:
    case Operator::shl:
    case Operator::shr: return tightest_level;
    default: return -1;  // prefix operators
  }
}

// MACRO-80 divides absolute values; both results have the sign of the quotient.
std::uint32_t signed_result_of(Operator operation, std::uint32_t a, std::uint32_t b) {
  const auto amount = [](std::uint32_t value) { return (value & 0x8000U) != 0 ? (0U - value) & word_mask : value; };
  const std::uint32_t result = operation == Operator::divide ? amount(a) / amount(b) : amount(a) % amount(b);
  return ((a ^ b) & 0x8000U) != 0 ? 0U - result : result;
}

std::uint32_t result_of(Operator operation, std::uint32_t a, std::uint32_t b) {
  const auto truth = [](bool holds) { return holds ? word_mask : 0U; };
  switch (operation) {
    case Operator::multiply: return a * b;
    case Operator::divide: return a / b;
    case Operator::mod: return a % b;
    case Operator::shl: return b > 15 ? 0 : a << b;
    case Operator::shr: return b > 15 ? 0 : a >> b;
    case Operator::add: return a + b;
    case Operator::subtract: return a - b;
    case Operator::eq: return truth(a == b);
    case Operator::ne: return truth(a != b);
    case Operator::lt: return truth(a < b);
    case Operator::le: return truth(a <= b);
    case Operator::gt: return truth(a > b);
    case Operator::ge: return truth(a >= b);
    case Operator::and_: return a & b;
    case Operator::or_: return a | b;
    default: return a ^ b;
  }
}

}  // namespace

std::optional<I8080Value> I8080Pass::expression() {
  after_operator_ = false;
  return level(0);
}

std::optional<Operator> I8080Pass::operation_of_token() const {
  if (token_.is('+')) return Operator::add;
  if (token_.is('-')) return Operator::subtract;
  if (token_.is('*')) return Operator::multiply;
  if (token_.is('/')) return Operator::divide;
  constexpr std::array relations{std::pair{"=", Operator::eq},  std::pair{"<>", Operator::ne}, std::pair{"<", Operator::lt},
                                 std::pair{"<=", Operator::le}, std::pair{">", Operator::gt},  std::pair{">=", Operator::ge}};
  for (const auto& [sign, operation] : relations)
    if (token_.is_sign(sign)) return operation;
  if (token_.kind != I8080TokenKind::name) return std::nullopt;
  const Word* const found = word(token_.value, WordKind::operation);
  return found == nullptr ? std::nullopt : std::optional(found->operation);
}

std::optional<I8080Value> I8080Pass::level(int precedence_level) {
  if (precedence_level > tightest_level) return primary();
  const auto leading = operation_of_token();
  std::optional<I8080Value> left;
  if (precedence_level == not_level && leading == Operator::not_) {
    left = prefix(Operator::not_, not_level);
  } else if (precedence_level == sum_level && !rules_.minus_is_tightest &&
             (leading == Operator::add || leading == Operator::subtract)) {
    left = prefix(*leading, tightest_level);
  } else {
    left = level(precedence_level + 1);
  }
  while (left) {
    const auto operation = operation_of_token();
    if (!operation || precedence(*operation) != precedence_level) return left;
    const std::size_t at = token_.column;
    advance();
    after_operator_ = true;
    const auto right = level(precedence_level + 1);
    if (!right) return std::nullopt;
    left = combine(*operation, *left, *right, at);
  }
  return left;
}

std::optional<I8080Value> I8080Pass::combine(Operator operation, const I8080Value& a, const I8080Value& b,
                                             std::size_t at) {
  const bool known = a.known && b.known;
  const bool divides = operation == Operator::divide || operation == Operator::mod;
  if (divides && b.bits == 0) {
    if (!known) return I8080Value{0, false, true, false};
    error(at, "a division by 0", "another divisor");
    return std::nullopt;
  }
  std::uint32_t bits = result_of(operation, a.bits, b.bits) & word_mask;
  if (divides) {
    const std::uint32_t with_sign = signed_result_of(operation, a.bits, b.bits) & word_mask;
    if (with_sign != bits && rules_.dialect == I8080Dialect::common) {
      warning(at, "a division of values above 7FFF", "--dialect: they are unsigned here, signed in MACRO-80");
    }
    if (rules_.divides_signed) bits = with_sign;
  }
  const bool logical =
      operation == Operator::and_ || operation == Operator::or_ || operation == Operator::xor_;
  return I8080Value{bits, known,
                    a.forward || b.forward, logical && (a.pattern || b.pattern)};
}

bool I8080Pass::go_deeper() {
  if (++nesting_ <= deepest_nesting) return true;
  unexpected("at most " + std::to_string(deepest_nesting) + " parentheses and operators inside each other");
  return false;
}

// A prefix operator; its operand includes infix operators of its level and above.
std::optional<I8080Value> I8080Pass::prefix(Operator operation, int operand_level) {
  if (!go_deeper()) return std::nullopt;
  advance();
  after_operator_ = operation != Operator::add;
  auto value = level(operand_level);
  --nesting_;
  if (!value) return std::nullopt;
  if (operation != Operator::add) value->pattern = operation == Operator::not_;
  switch (operation) {
    case Operator::not_: value->bits = ~value->bits & word_mask; break;
    case Operator::subtract: value->bits = (0U - value->bits) & word_mask; break;
    case Operator::high: value->bits >>= 8; break;
    case Operator::low: value->bits &= 0xFFU; break;
    default: break;  // a plus sign or a parenthesis
  }
  return value;
}

std::optional<I8080Value> I8080Pass::primary() {
  const bool behind_operator = std::exchange(after_operator_, false);
  if (token_.kind == I8080TokenKind::number) {
    const I8080Value value{token_.number, true, false, false};
    if (token_.wrapped) warning(token_.column, quoted(token_.text), "at most 65535 (0FFFFH): it is taken modulo 65536");
    advance();
    return value;
  }
  if (token_.kind == I8080TokenKind::string && token_.value.size() <= 2) {
    I8080Value value;
    std::string text = token_.value;
    if (text.size() == 2 && text[0] != text[1] && rules_.dialect == I8080Dialect::common) {
      warning(token_.column, quoted(token_.text) + " as a value",
              "--dialect: its first character is the high byte here, the low byte in MAC");
    }
    if (rules_.first_character_is_low) std::reverse(text.begin(), text.end());
    for (const char c : text) value.bits = value.bits << 8 | static_cast<std::uint8_t>(c);
    advance();
    return value;
  }
  if (token_.is('$') || token_.is('*')) {
    const bool behind = location_ != statement_location_;
    if (behind && rules_.dialect == I8080Dialect::common) {
      warning(token_.column, quoted(token_.text) + " after the first item",
              "--dialect: it is the address of the item here, of the statement in Intel's assembler");
    }
    advance();
    const std::uint32_t here = behind && rules_.location_moves ? location_ : statement_location_;
    return I8080Value{(here + phase_) & word_mask, true, false, false};
  }
  if (token_.is('(')) {
    auto value = prefix(Operator::add, 0);
    if (!value) return std::nullopt;
    if (!token_.is(')')) {
      unexpected("')'");
      return std::nullopt;
    }
    advance();
    return value;
  }
  const auto operation = operation_of_token();
  if (token_.kind == I8080TokenKind::name && operation && precedence(*operation) >= 0 && label_of(token_.value) != nullptr)
    return name_value();
  if (operation == Operator::nul) {
    const I8080Token rest = I8080Lexer(lexer_).next();
    const bool nothing =
        rest.kind == I8080TokenKind::end;
    lexer_ = I8080Lexer();
    advance();
    return I8080Value{nothing ? word_mask : 0U, true, false, false};
  }
  if (operation && (precedence(*operation) < 0 || precedence(*operation) == sum_level)) {
    const bool takes_byte = *operation == Operator::high || *operation == Operator::low;
    if (behind_operator && rules_.fails_on_weak_prefixes && *operation != Operator::add) {
      warning(token_.column, quoted(token_.text) + " after an operator of higher precedence",
              "parentheses around it and its operand: MAC refuses it, or makes other bytes");
    }
    if (takes_byte && rules_.high_is_loosest) return prefix(*operation, 0);
    const std::size_t at = token_.column;
    const std::string written(token_.text);
    auto value = prefix(*operation, *operation == Operator::not_ ? relation_level : tightest_level + 1);
    const auto behind = takes_byte && rules_.dialect == I8080Dialect::common ? operation_of_token() : std::nullopt;
    if (value && behind && precedence(*behind) >= 0) {
      warning(at, quoted(written) + " before an operator",
              "parentheses, or --dialect: it applies to one operand here, to all that follows in MAC");
    }
    return value;
  }
  if (token_.kind == I8080TokenKind::name && !operation) return name_value();
  unexpected(token_.kind == I8080TokenKind::string ? "one or two characters" : "a value");
  return std::nullopt;
}

// A label may have the name of an instruction, a register or an infix operator. Null if there is no such label.
const Symbol* I8080Pass::label_of(const std::string& key) const {
  const Symbol* const found = engine_.find(key);
  return found != nullptr && found->defined_in_pass != 0 ? found : nullptr;
}

std::optional<I8080Value> I8080Pass::name_value() {
  const I8080Token name = token_;
  if (name.external) engine_.declare(name.value, false);
  const bool is_label = label_of(name.value) != nullptr;
  if (const Word* const found = word(name.value, WordKind::mnemonic); found != nullptr && !is_label) {
    const auto opcode = opcode_value(found->rows);
    return opcode ? std::optional(I8080Value{*opcode, true, false, false}) : std::nullopt;
  }
  advance();
  if (const Word* const found = word(name.value, WordKind::register_name); found != nullptr && !is_label)
    return I8080Value{found->value, true, false, false};
  const Symbol* const symbol = engine_.find(name.value);
  if (symbol != nullptr && symbol->value) {
    const bool forward = symbol->kind != SymbolKind::define && !engine_.is_defined(*symbol);
    return I8080Value{*symbol->value, true, forward || (symbol->form & forward_form) != 0, (symbol->form & pattern_form) != 0};
  }
  if (!engine_.final()) return I8080Value{0, false, true, false};
  const std::string elsewhere = suggest_declaration(name.value);
  if (engine_.means_external(name.value)) {
    error(name.column, "external symbol " + quoted(name.text),
          elsewhere.empty() ? "one that a source of this program defines: there is no linker" : elsewhere);
  } else if (symbol != nullptr && symbol->defined_in_pass != 0) {
    error(name.column, quoted(name.text) + ", whose value is not known",
          "an EQU that does not depend on itself");
  } else {
    error(name.column, "undefined symbol " + quoted(name.text), elsewhere.empty() ? "one that is defined" : elsewhere);
  }
  return std::nullopt;
}

std::optional<std::uint16_t> I8080Pass::constant_value(std::string_view what) {
  const std::size_t at = token_.column;
  const auto value = expression();
  if (!value) return std::nullopt;
  if (!value->known || value->forward) {
    error(at, "a forward reference", std::string(what) + " known at this line");
    return std::nullopt;
  }
  return static_cast<std::uint16_t>(value->bits);
}

std::optional<std::uint8_t> I8080Pass::byte_of(const I8080Value& value, std::size_t at) {
  const bool fits = value.bits <= 0xFF || value.bits >= 0xFF80 || (value.pattern && value.bits >= 0xFF00);
  if (value.known && !fits) {
    error(at, "value " + std::to_string(value.bits) + " (" + image::hexadecimal(value.bits, 4) + ")",
          "a byte, -128 to 255");
    return std::nullopt;
  }
  return static_cast<std::uint8_t>(value.bits);
}

}  // namespace sightline::assembler
