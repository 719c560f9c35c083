#include "tools/asm/pdp7/bell.hpp"

#include <algorithm>
#include <utility>

#include "emulators/core/word.hpp"
#include "emulators/pdp7/isa.hpp"
#include "host/base/number.hpp"
#include "tools/asm/pdp7/characters.hpp"
#include "tools/image/core_image.hpp"

namespace sightline::assembler {
namespace {

constexpr std::uint32_t last_location = image::field_mask;  // 017777 (assm2)
constexpr std::string_view location_name = ".";
constexpr std::string_view base_name = "..";

}  // namespace

void enter_bell_symbols(SymbolTable& symbols) {
  Symbol& sys = symbols["sys"];
  sys.kind = SymbolKind::permanent;
  sys.value = pdp7::indirect_bit;  // cal i
  sys.form = static_cast<int>(Form::memory);
}

void relocate_bell_symbols(Pdp7Program& program) {
  for (auto& [key, symbol] : program.symbols) {
    if (symbol.form != relocatable_form || !symbol.value) continue;
    symbol.value = (*symbol.value + program.base.value_or(first_bell_base)) & core::Word18::mask;
    symbol.form = 0;
  }
}

BellPass::BellPass(std::span<const SourceFile> sources, Pdp7Program& program, int number, bool final)
    : sources_(sources), program_(program), number_(number), final_(final) {
  program_.base.reset();
}

void BellPass::run() {
  for (std::size_t i = 0; i < sources_.size(); ++i) read_file(i);
  for (std::size_t digit = 0; digit < relative_.size(); ++digit) {
    auto& labels = program_.relative_labels[digit];
    labels.clear();
    if (forward_[digit]) relative_[digit].push_back(*forward_[digit]);
    for (const Number& label : relative_[digit])
      labels.push_back(label.value | (label.relocatable != 0 ? relocatable_label : 0));
  }
}

// --- Characters ---

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
  const std::string shown = describe({TokenKind::bad, text_.substr(at_, 1), position(), false});
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

// --- Statements ---

void BellPass::read_file(std::size_t index) {
  file_ = index;
  text_ = sources_[index].text;
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
    define_relative_label(static_cast<std::size_t>(name[0] - '0'), location_);
  } else {
    error(at, shown_name(std::string(name.substr(0, 40)) + next), "a relative label 0: to 9:, or a name");
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
  Symbol& symbol = look_up(name, at);
  if (symbol.kind == SymbolKind::define)
    return error(at, "label " + shown_name(name) + ", already defined at the command line", "another name");
  const bool first = symbol.defined_in_pass != number_;
  if (!first) set_again(symbol, name, at);
  if (symbol.kind == SymbolKind::permanent) symbol.was_permanent = true;
  if (symbol.was_permanent) {
    warning(at, "label " + shown_name(name) + ", which hides the instruction of this name",
            "another name");
  }
  if (final_ && first && !symbol.several_values && symbol.value != location_.value) {
    error(at, "label " + shown_name(name) + " at another location than in the pass before",
          "locations that do not depend on themselves");
  }
  symbol.kind = SymbolKind::tag;
  if (first) symbol.defined = at;
  symbol.value = location_.value;
  symbol.form = location_.relocatable != 0 ? relocatable_form : 0;
  symbol.defined_in_pass = number_;
}

// `as` lets a name be set again (assm4). Before its first place in the source a name has its last value.
void BellPass::set_again(Symbol& symbol, std::string_view name, const Position& at) {
  if (!symbol.set_again) {
    warning(at, shown_name(name) + " set again",
            "another name than at " + sources_[symbol.defined.file].name + ":" + std::to_string(symbol.defined.line) +
                "; before that line it has its last value");
  }
  symbol.set_again = final_;
  symbol.several_values = true;
}

// 1: is 1b from here on, and 1f up to here.
void BellPass::define_relative_label(std::size_t digit, const Number& value) {
  base_used_ = true;
  relative_[digit].push_back(value);
  forward_[digit].reset();
  backward_[digit] = value;
}

void BellPass::set_relative_label(std::size_t digit, bool forward, bool assigned) {
  if (!assigned) base_used_ = true;
  const auto value = assigned ? assigned_value() : location_;
  if (!value) return skip_statement();
  (forward ? forward_ : backward_)[digit] = *value;
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
  Symbol& symbol = look_up(name, at);
  if (symbol.kind == SymbolKind::define) return;
  if (symbol.kind == SymbolKind::tag && symbol.defined_in_pass == number_) set_again(symbol, name, at);
  const int form = value->relocatable != 0 ? relocatable_form : 0;
  const bool same = symbol.kind == SymbolKind::permanent && symbol.value == value->value && form == 0;
  if (symbol.kind == SymbolKind::permanent && !same && value->known) symbol.was_permanent = true;
  if (symbol.was_permanent) {
    warning(at, "an assignment to " + shown_name(name) + ", which changes the instruction of this name",
            "another name");
  }
  const bool first = symbol.defined_in_pass != number_;
  if (!first && value->known && symbol.value && symbol.value != value->value) symbol.several_values = true;
  if (final_ && first && !symbol.several_values && symbol.value != value->value) {
    error(at, shown_name(name) + " with another value than in the pass before",
          "a definition that does not depend on itself");
  }
  // A source may define an instruction again with the same value; it stays an instruction.
  const bool known_instruction = same || (symbol.form != 0 && symbol.form != relocatable_form &&
                                          !symbol.was_permanent && symbol.value == value->value);
  if (first) symbol.defined = at;
  symbol.kind = SymbolKind::assigned;
  symbol.value = value->known ? std::optional(value->value) : std::nullopt;
  if (!known_instruction) symbol.form = form;
  symbol.defined_in_pass = number_;
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
  if (final_ && location_in_core(at)) {
    const std::uint32_t address = relocated(location_);
    const auto [place, added] = occupied_.try_emplace(address, at);
    if (!added) {
      const Position& first = place->second;
      warning(at,
              "a second word at " + base::octal(address, 6) + ", which replaces that of " +
                  sources_[first.file].name + ":" + std::to_string(first.line),
              "one word per location");
    }
    program_.words.push_back({at, address, word, {}});
  }
  location_.value = (location_.value + 1) & core::Word18::mask;
}

std::uint32_t BellPass::relocated(const Number& value) const {
  const std::uint32_t base = value.relocatable != 0 ? program_.base.value_or(first_bell_base) : 0;
  return (value.value + base) & core::Word18::mask;
}

Symbol& BellPass::look_up(std::string_view name, const Position& at) {
  Symbol& symbol = program_.symbols[name];
  if (final_ && (name.size() > 8 || symbol.name.size() > 8) && name != symbol.name &&
      clashes_.insert(std::string(name)).second) {
    warning(at, shown_name(name) + ", the same symbol as " + shown_name(symbol.name),
            "names that differ in their first eight characters");
  }
  return symbol;
}

void BellPass::report(Severity severity, const Position& at, std::string found, std::string expected) {
  if (!final_) return;
  program_.diagnostics.emplace_back(at, Diagnostic{severity, sources_[at.file].name, at.line, at.column,
                                                   std::move(found), std::move(expected)});
}

void BellPass::error(const Position& at, std::string found, std::string expected) {
  report(Severity::error, at, std::move(found), std::move(expected));
}

void BellPass::warning(const Position& at, std::string found, std::string expected) {
  report(Severity::warning, at, std::move(found), std::move(expected));
}

}  // namespace sightline::assembler
