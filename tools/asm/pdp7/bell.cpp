#include "tools/asm/pdp7/bell.hpp"

#include <algorithm>
#include <utility>

#include "emulators/core/word.hpp"
#include "emulators/pdp7/isa.hpp"
#include "host/base/number.hpp"
#include "tools/asm/pdp7/dec.hpp"
#include "tools/image/core_image.hpp"

namespace sightline::assembler {
namespace {

constexpr std::uint32_t last_location = image::field_mask;  // 017777 (assm2)
constexpr std::string_view location_name = ".";
constexpr std::string_view base_name = "..";
constexpr std::uint32_t left_half = 9;  // bits that a character in the left half of a word is shifted by
constexpr std::string_view an_operand = "a name, a number, '.' or a character <a";

std::uint32_t code_of(char c) {
  return static_cast<unsigned char>(c);
}

bool seven_bits(char c) {
  return c >= ' ' && code_of(c) < 0177;
}

// A letter by the character classes of as.s (lactab, class 6).
bool bell_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '.' || c == '*';
}

// Symbol::form of a relocatable symbol, and the mark of a relocatable value among the places of the engine: `..` is added to
// both.
constexpr int relocatable_form = 100;
constexpr std::uint32_t relocatable_mark = 01000000;

}  // namespace

void relocate_bell_symbols(Pdp7Program& program) {
  for (auto& [key, symbol] : program.engine.symbols()) {
    if (symbol.form == relocatable_form && symbol.value)
      symbol.value = (*symbol.value + program.base.value_or(first_bell_base)) & core::Word18::mask;
  }
}

void BellPass::run() {
  for (std::size_t i = 0; i < engine_.sources(); ++i) read_file(i);
  program_.end_source();
}

// --- Characters

char BellPass::peek(std::size_t ahead) const {
  return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
}

bool BellPass::at_end_of_statement() const {
  const char c = peek();
  return at_ >= text_.size() || c == ';' || c == '\n' || c == '"';
}

void BellPass::skip_blanks() {
  while (at_ < text_.size() && is_pdp7_blank(text_[at_])) ++at_;
}

void BellPass::skip_statement() {
  while (!at_end_of_statement()) ++at_;
}

std::string_view BellPass::take_name() {
  const std::size_t start = at_;
  while (at_ < text_.size() && (bell_letter(text_[at_]) || is_pdp7_digit(text_[at_]))) ++at_;
  return text_.substr(start, at_ - start);
}

// What the message shows as found here; names --dialect dec if the construct belongs to it.
std::string BellPass::found() const {
  if (at_ >= text_.size()) return "the end of the file";
  const char c = text_[at_];
  if (c == '\n' || c == ';' || c == '"') return "the end of the statement";
  const std::string shown = in_quotes(text_.substr(at_, 1));
  switch (c) {
    case ',': return shown + ", which ends a tag in --dialect dec";
    case '/': return shown + ", an origin or a comment of --dialect dec";
    case '(':
    case ')': return shown + ", a literal of --dialect dec";
    case '#':
    case '$': return shown + ", a variable of --dialect dec";
    case '!':
    case '&': return shown + ", an operator of --dialect dec";
    default: return shown;
  }
}

// --- Statements

void BellPass::read_file(std::size_t index) {
  file_ = index;
  program_.begin_source(index);
  text_ = engine_.file(index).text;
  at_ = 0;
  line_ = 1;
  line_start_ = 0;
  for (skip_blanks(); at_ < text_.size(); skip_blanks()) {
    if (!at_end_of_statement()) statement();
    skip_blanks();
    if (!at_end_of_statement()) {
      error(position(), found(), "an operator or the end of the statement");
      skip_statement();
    }
    if (peek() == '"') at_ = std::min(text_.find('\n', at_), text_.size());
    if (peek() == '\n') {
      ++line_;
      line_start_ = at_ + 1;
    }
    if (at_ < text_.size()) ++at_;
  }
}

void BellPass::statement() {
  while (label_or_assignment()) {
    skip_blanks();
    if (at_end_of_statement()) return;
  }
  make_word();
}

// True after a label, an assignment, or an error in one.
bool BellPass::label_or_assignment() {
  const std::size_t start = at_;
  const Position at = position();
  const bool named = bell_letter(peek());
  std::string_view name;
  if (named) {
    name = take_name();
  } else {
    while (is_pdp7_digit(peek())) ++at_;
    name = text_.substr(start, at_ - start);
  }
  // 9f: and 9b = set what 9f and 9b mean from here on to the next 9: (assm4, assm5).
  const bool sets_relative = !named && name.size() == 1 && (peek() == 'f' || peek() == 'b') &&
                             !bell_letter(peek(1)) && !is_pdp7_digit(peek(1));
  const char direction = sets_relative ? text_[at_++] : '\0';
  skip_blanks();
  const char next = peek();
  const bool right_half = peek(1) == '>';  // :> and => are characters
  if (name.empty() || (next != ':' && next != '=') || right_half) {
    at_ = start;
    return false;
  }
  ++at_;
  if (named && next == ':') {
    define_label(name, at);
  } else if (named) {
    assign(name, at);
  } else if (sets_relative) {
    set_relative_label(static_cast<std::size_t>(name[0] - '0'), direction == 'f', next == '=');
  } else if (next == ':' && name.size() == 1) {
    base_used_ = true;
    engine_.places(static_cast<std::size_t>(name[0] - '0')).add(packed(location_));
  } else {
    error(at, in_quotes(std::string(name.substr(0, 40)) + next), "a relative label 0: to 9:, or a name");
    if (next == '=') skip_statement();
  }
  return true;
}

void BellPass::define_label(std::string_view name, const Position& at) {
  if (name == location_name || name == base_name) {
    return error(at, "label '" + std::string(name) + "'",
                 "another name; '" + std::string(name) + " =' sets it");
  }
  base_used_ = true;
  Symbol& symbol = engine_.look_up(name, at);
  if (symbol.kind == SymbolKind::define)
    return error(at, "label " + in_quotes(name) + ", already defined at the command line", "another name");
  if (engine_.is_defined(symbol)) set_again(symbol, name, at);
  if (symbol.kind == SymbolKind::permanent) symbol.was_permanent = true;
  if (symbol.was_permanent)
    engine_.warning(at, "label " + in_quotes(name) + ", which hides the instruction of this name", "another name");
  engine_.define(symbol, SymbolKind::label, location_.value, at, location_.relocatable != 0 ? relocatable_form : 0);
}

// `as` lets a name be set again (assm4). Before its first place in the source a name has its last value.
void BellPass::set_again(Symbol& symbol, std::string_view name, const Position& at) {
  if (!engine_.final() || std::exchange(symbol.set_again, true)) return;
  engine_.warning(at, in_quotes(name) + " set again",
                  "another name than at " + engine_.where(symbol.defined) + "; before that line it has its last value");
}

// 9f: and 9f = set what 9f means from here to the next 9:, and 9b likewise.
void BellPass::set_relative_label(std::size_t digit, bool forward, bool assigned) {
  if (!assigned) base_used_ = true;
  const auto value = assigned ? assigned_value() : location_;
  if (!value) return skip_statement();
  if (!value->known) return engine_.await_value();
  Places& labels = engine_.places(digit);
  forward ? labels.set_next(packed(*value)) : labels.set_last(packed(*value));
}

std::optional<BellPass::Number> BellPass::assigned_value() {
  instruction_.reset();
  skip_blanks();
  const Position place = position();
  const auto read = expression();
  return read ? check_relocation(*read, place) : read;
}

void BellPass::assign(std::string_view name, const Position& at) {
  in_location_ = name == location_name || name == base_name;
  skip_blanks();
  const Position place = position();
  const auto value = assigned_value();
  in_location_ = false;
  if (!value) return skip_statement();
  if (name == location_name) return set_location(*value, place);
  if (name == base_name) return set_base(*value, place);
  Symbol& symbol = engine_.look_up(name, at);
  if (symbol.kind == SymbolKind::define) return;
  if (symbol.kind == SymbolKind::label && engine_.is_defined(symbol)) set_again(symbol, name, at);
  const int form = value->relocatable != 0 ? relocatable_form : 0;
  const bool same = symbol.kind == SymbolKind::permanent && symbol.value == value->value && form == 0;
  if (symbol.kind == SymbolKind::permanent && !same && value->known) symbol.was_permanent = true;
  if (symbol.was_permanent) {
    engine_.warning(at, "an assignment to " + in_quotes(name) + ", which changes the instruction of this name",
                    "another name");
  }
  // A source may define an instruction again with the same value; it stays an instruction.
  const bool known_instruction = same || (symbol.form != 0 && symbol.form != relocatable_form &&
                                          !symbol.was_permanent && symbol.value == value->value);
  engine_.define(symbol, SymbolKind::assigned, value->known ? std::optional(value->value) : std::nullopt, at,
                 known_instruction ? symbol.form : form);
}

std::uint32_t BellPass::packed(const Number& value) {
  return value.value | (value.relocatable != 0 ? relocatable_mark : 0);
}

BellPass::Number BellPass::unpacked(std::uint32_t packed) {
  return {packed & core::Word18::mask, (packed & relocatable_mark) != 0 ? 1 : 0, true};
}

void BellPass::set_location(const Number& value, const Position& at) {
  if (!value.known) return;
  if (relocated(value) > last_location) {
    return error(at, "location " + base::octal(relocated(value), 6), "one up to 017777");
  }
  location_ = value;
}

void BellPass::set_base(const Number& value, const Position& at) {
  if (!value.known) return;
  if (value.relocatable != 0 || value.value > last_location) {
    return error(at, "'..' " + base::octal(value.value, 6) + (value.relocatable != 0 ? ", a location" : ""),
                 "a number up to 017777");
  }
  if (base_used_ && value.value != program_.base.value_or(first_bell_base)) {
    return error(at, "'..' set after the first word or label", "one value for the program, at its beginning");
  }
  program_.base = value.value;
}

void BellPass::make_word() {
  const Position at = position();
  base_used_ = true;
  instruction_.reset();
  const auto read = expression();
  const auto value = read ? check_relocation(*read, at) : read;
  if (!value) skip_statement();
  std::uint32_t word = value && value->known ? relocated(*value) : 0;
  if (value && value->known && instruction_) {
    const auto& meant = pdp7::instruction_of(*instruction_);
    const auto& made = pdp7::instruction_of(word);
    const bool memory = meant.instruction_class == pdp7::Class::memory;
    if (memory ? meant.value != made.value : meant.instruction_class != made.instruction_class) {
      error(at, "word " + base::octal(word, 6) + ", which is no " + std::string(meant.mnemonic),
            memory ? "an operand from 0 to 017777, and i" : "an operand that fits the instruction");
    }
  }
  emit(word, at);
}

bool BellPass::location_in_core(const Position& at) {
  const std::uint32_t address = relocated(location_);
  if (address <= last_location) return true;
  if (address == last_location + 1) error(at, "a word after location 017777", "the end of the program");
  return false;
}

void BellPass::emit(std::uint32_t word, const Position& at) {
  if (engine_.final() && location_in_core(at)) {
    const std::uint32_t address = relocated(location_);
    program_.put(at, address, word, base::octal(address, 6), "location");
  }
  location_.value = (location_.value + 1) & core::Word18::mask;
}

std::uint32_t BellPass::relocated(const Number& value) const {
  const std::uint32_t base = value.relocatable != 0 ? program_.base.value_or(first_bell_base) : 0;
  return (value.value + base) & core::Word18::mask;
}

// --- Expressions

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
std::optional<BellPass::Number> BellPass::relative_label(const Position& at, std::size_t digit, bool forward) {
  const Places& labels = engine_.places(digit);
  if (const auto label = forward ? labels.next() : labels.last(); label && !(forward && in_location_)) return unpacked(*label);
  const std::string name = std::to_string(digit);
  if (forward && in_location_) {
    error(at, "'" + name + "f' in a location", "a label that is defined before");
  } else if (forward) {
    error(at, "'" + name + "f' without a label " + name + ": after it", "the label, or " + name + "b");
  } else {
    error(at, "'" + name + "b' without a label " + name + ": before it", "the label, or " + name + "f");
  }
  return Number{0, 0, false};
}

std::optional<BellPass::Number> BellPass::symbol(std::string_view name, const Position& at) {
  if (name == ".") return location_;
  if (name == "..") return Number{program_.base.value_or(first_bell_base), 0, true};
  const Symbol& found = engine_.look_up(name, at);
  if (found.kind == SymbolKind::undefined) {
    undefined(name, at);
    return Number{0, 0, false};
  }
  const bool of_source = found.kind == SymbolKind::label || found.kind == SymbolKind::assigned;
  if (of_source && !engine_.is_defined(found) && in_location_) {
    error(at, in_quotes(name) + " before its first definition",
          "a name that is defined before, because the location depends on it");
    return Number{0, 0, false};
  }
  if (!found.value) {
    error(at, in_quotes(name) + " without a value", "a definition that does not depend on itself");
    return Number{0, 0, false};
  }
  const auto form = static_cast<Form>(found.form);
  const bool instruction = found.form != relocatable_form && form >= Form::memory;
  if (instruction && !instruction_) instruction_ = *found.value;
  return Number{*found.value, found.form == relocatable_form ? 1 : 0, true};
}

// The message suggests what the writer may have meant: a word of the other dialect, or the other case.
void BellPass::undefined(std::string_view name, const Position& at) {
  const std::string shown = in_quotes(name);
  if (peek() == ',') return error(at, shown + ", a tag of --dialect dec", "a label, with ':' after the name");
  const std::string lower = lower_case(name);
  const Symbol* const small = lower == name ? nullptr : engine_.find_in(lower, std::nullopt);
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
