#include <algorithm>
#include <string>

#include "emulators/core/word.hpp"
#include "host/base/number.hpp"
#include "tools/asm/pdp7/bell.hpp"
#include "tools/asm/pdp7/characters.hpp"

namespace sightline::assembler {
namespace {

constexpr std::uint32_t left_half = 9;  // bits that a character in the left half of a word is shifted by
constexpr std::string_view an_operand = "a name, a number, '.' or a character <a";

std::uint32_t code_of(char c) {
  return static_cast<unsigned char>(c);
}

bool seven_bits(char c) {
  return c >= ' ' && code_of(c) < 0177;
}

}  // namespace

std::string shown_name(std::string_view name) {
  constexpr std::size_t most = 40;
  return "'" + std::string(name.substr(0, most)) + (name.size() > most ? "...'" : "'");
}

// A letter by the character classes of as.s (lactab, class 6).
bool bell_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '.' || c == '*';
}

// Sums, separated by blanks, are ORed.
std::optional<BellPass::Number> BellPass::expression() {
  std::optional<Number> left = sum();
  for (skip_blanks(); left && !at_end_of_statement(); skip_blanks()) {
    const char before = text_[at_ - 1];
    const bool separated = before == ' ' || before == '\t' || before == '\r' || before == '\f';
    if (!separated && !after_left_character_) return left;
    const std::optional<Number> right = sum();
    if (!right) return std::nullopt;
    left = Number{left->value | right->value, left->relocatable + right->relocatable,
                  left->known && right->known};
  }
  return left;
}

std::optional<BellPass::Number> BellPass::sum() {
  std::optional<Number> left;
  const bool sign = (peek() == '+' || peek() == '-') && peek(1) != '>';
  if (sign) {
    left = Number{};
  } else {
    left = operand();
  }
  for (;;) {
    if (!left) return left;
    const std::size_t behind = at_;
    skip_blanks();
    const char operation = peek();
    if (operation != '+' && operation != '-') {
      at_ = behind;
      return left;
    }
    ++at_;
    skip_blanks();
    const std::optional<Number> right = operand();
    if (!right) return std::nullopt;
    const bool known = left->known && right->known;
    if (operation == '+') {
      left = Number{(left->value + right->value) & core::Word18::mask, left->relocatable + right->relocatable,
                    known};
    } else {
      left = Number{(left->value - right->value) & core::Word18::mask, left->relocatable - right->relocatable,
                    known};
    }
  }
}

std::optional<BellPass::Number> BellPass::operand() {
  after_left_character_ = false;
  const Position at = position();
  if (at_end_of_statement()) {
    error(at, found(), std::string(an_operand));
    return std::nullopt;
  }
  if (peek() == '<' || peek() == '>' || peek(1) == '>') return character();
  if (is_pdp7_digit(peek())) return number();
  if (bell_letter(peek())) return symbol(take_name(), at);
  error(at, found(), std::string(an_operand));
  return std::nullopt;
}

// <a, a> and >a. The last is not in as.s; printed sources have it, and as7 (pdp7-unix, tools/as7) reads it as
// a>.
std::optional<BellPass::Number> BellPass::character() {
  const Position at = position();
  const bool left = peek() == '<';
  const bool behind = !left && peek(1) != '>';
  const char c = left || behind ? peek(1) : peek();
  if (!seven_bits(c) || (left && c == '"')) {
    error(at,
          "no character " + std::string(left || behind ? "after '" : "before '") + (left ? '<' : '>') + "'",
          c == '"' ? "another than '\"', which begins a comment; its code is 042"
                   : "one of ASCII, blank to '~', or its code as a number");
    return std::nullopt;
  }
  advance(2);
  after_left_character_ = left;  // an operand after <a needs no blank before it
  return Number{left ? code_of(c) << left_half : code_of(c), 0, true};
}

std::optional<BellPass::Number> BellPass::number() {
  const Position at = position();
  const std::size_t start = at_;
  while (is_pdp7_digit(peek())) ++at_;
  const std::string_view digits = text_.substr(start, at_ - start);
  const char next = peek();
  if (digits.size() == 1 && (next == 'f' || next == 'b') && !bell_letter(peek(1)) && !is_pdp7_digit(peek(1))) {
    ++at_;
    return relative_label(at, static_cast<std::size_t>(digits[0] - '0'), next == 'f');
  }
  if (bell_letter(next)) {
    const std::string shown(
        text_.substr(start, std::min<std::size_t>(take_name().size() + digits.size(), 20)));
    error(at, "'" + shown + "'", "a number, or a relative label 0b to 9b or 0f to 9f");
    return std::nullopt;
  }
  const bool octal = digits[0] == '0';
  std::uint32_t n = 0;
  for (const char c : digits) {
    if (octal && c > '7') {
      error(at, "'" + std::string(1, c) + "' in octal number '" + std::string(digits.substr(0, 20)) + "'",
            "octal digits; a decimal number begins with another digit than 0");
      return std::nullopt;
    }
    n = n * (octal ? 8U : 10U) + code_of(c) - code_of('0');
    if (n > core::Word18::mask) {
      error(at, "number '" + std::string(digits.substr(0, 20)) + "'", "at most 0777777, which is 18 bits");
      return std::nullopt;
    }
  }
  return Number{n, 0, true};
}

// A forward reference takes its value from the pass before: the next definition after those that this pass has read.
std::optional<BellPass::Number> BellPass::relative_label(const Position& at, std::size_t digit,
                                                         bool forward) {
  const std::size_t next = relative_[digit].size();
  const auto& all = program_.relative_labels[digit];
  const auto& set = forward ? forward_[digit] : backward_[digit];
  if (set) return set;
  if (forward && (in_location_ || next >= all.size())) {
    const std::string name = std::to_string(digit);
    if (in_location_) {
      error(at, "'" + name + "f' in a location", "a label that is defined before");
    } else {
      error(at, "'" + name + "f' without a label " + name + ": after it", "the label, or " + name + "b");
    }
    return Number{0, 0, false};
  }
  if (!forward) {
    const std::string name = std::to_string(digit);
    error(at, "'" + name + "b' without a label " + name + ": before it", "the label, or " + name + "f");
    return Number{0, 0, false};
  }
  const std::uint32_t label = all[next];
  return Number{label & core::Word18::mask, (label & relocatable_label) != 0 ? 1 : 0, true};
}

std::optional<BellPass::Number> BellPass::symbol(std::string_view name, const Position& at) {
  if (name == ".") return location_;
  if (name == "..") return Number{program_.base.value_or(first_bell_base), 0, true};
  Symbol& found = look_up(name, at);
  if (found.kind == SymbolKind::undefined) {
    undefined(name, at);
    return Number{0, 0, false};
  }
  const bool of_source = found.kind == SymbolKind::tag || found.kind == SymbolKind::assigned;
  if (of_source && found.defined_in_pass != number_ && in_location_) {
    error(at, shown_name(name) + " before its first definition",
          "a name that is defined before, because the location depends on it");
    return Number{0, 0, false};
  }
  if (!found.value) {
    error(at, shown_name(name) + " without a value", "a definition that does not depend on itself");
    return Number{0, 0, false};
  }
  const auto form = static_cast<Form>(found.form);
  const bool instruction = found.form != relocatable_form && form >= Form::memory;
  if (instruction && !instruction_) instruction_ = *found.value;
  return Number{*found.value, found.form == relocatable_form ? 1 : 0, true};
}

// The message suggests what the writer may have meant: a word of the other dialect, or the other case.
void BellPass::undefined(std::string_view name, const Position& at) {
  const std::string shown = shown_name(name);
  if (peek() == ',') return error(at, shown + ", a tag of --dialect dec", "a label, with ':' after the name");
  const std::string lower = lower_case(name);
  const Symbol* const small = lower == name ? nullptr : program_.symbols.find(lower);
  if (small != nullptr && small->kind == SymbolKind::permanent) {
    return error(at, "undefined name " + shown + ", upper case as in --dialect dec", "'" + lower + "'");
  }
  if (!pseudo_operation_named(name).empty()) {
    return error(at, shown + ", a pseudo-operation of --dialect dec", "a name that the sources define");
  }
  error(at, "undefined name " + shown, "a label or an assignment in one of the sources");
}

std::optional<BellPass::Number> BellPass::check_relocation(Number value, const Position& at) {
  if (!value.known || value.relocatable == 0 || value.relocatable == 1) return value;
  error(at, value.relocatable < 0 ? "a number minus a location" : "the sum of two locations",
        "at most one location that is added, or the difference of two");
  return std::nullopt;
}

}  // namespace sightline::assembler
