#include "tools/asm/i8080/pass.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "tools/image/binary.hpp"

namespace sightline::assembler {
namespace {

using image::hexadecimal;

constexpr std::size_t characters_a_line = 256;  // a longer line counts as several lines in the limit
constexpr std::size_t most_places_shown = 3;    // of nested expansions

std::string local_name(std::size_t number) {
  std::string digits = std::to_string(number);
  if (digits.size() < 4) digits.insert(0, 4 - digits.size(), '0');
  return "??" + digits;
}

// Prefix operators: a label of that name could not be distinguished from the operator.
bool is_prefix(Operator operation) {
  return operation == Operator::not_ || operation == Operator::high || operation == Operator::low || operation == Operator::nul;
}

}  // namespace

void I8080Pass::run() {
  for (std::size_t file = 0; file < engine_.sources() && !engine_.stopped(); ++file) {
    engine_.begin_source(file);
    radix_ = 10;
    push(std::make_unique<I8080Frame>(file, engine_.file(file).text, rules_));
    while (!frames_.empty() && !engine_.stopped()) {
      if (const auto statement = frames_.back()->next_statement()) {
        statement_ = *statement;
        this->statement();
      } else if (!next_line()) {
        end_of_frame();
      }
    }
    leave_common();
    phase_ = 0;
    enter_segment("cseg");
  }
  warn_about_undefined_publics();
}

// Lines

bool I8080Pass::next_line() {
  I8080Frame& frame = *frames_.back();
  if (!frame.next_line([this] { return local_name(++locals_); })) return false;
  statement_ = {frame.line(), 0, true};
  count_lines(1 + frame.line().size() / characters_a_line);
  if (frame.line().size() > longest_line) {
    error(0, std::string("a longer line") + (frame.is_expansion() ? " after expansion" : ""),
          "at most " + std::to_string(longest_line) + " characters");
    engine_.stop();
  }
  if (engine_.final() && options_.listing) frame.listed = engine_.add_line((frame.is_expansion() ? "+" : "") + std::string(frame.line()));
  return true;
}

void I8080Pass::count_lines(std::size_t more) {
  lines_ += more;
  if (lines_ <= options_.most_lines) return;
  error(0, "more than " + std::to_string(options_.most_lines) + " lines with all expansions",
        "repeats and macros that end");
  engine_.stop();
}

void I8080Pass::end_of_frame() {
  const I8080Frame& frame = *frames_.back();
  const std::string end =
      frame.is_expansion() ? "the end of " + frame.name() : "the end of " + engine_.file(frame.file()).name;
  while (conditionals_.size() > frame.conditionals) {
    report(Severity::warning, conditionals_.back().opened, end + " inside this IF", "ENDIF; it ends here");
    conditionals_.pop_back();
  }
  if (definition_ && definition_->frames == frames_.size()) {
    report(Severity::error, definition_->opened, end + " inside this definition", "ENDM");
    definition_.reset();
  }
  if (comment_end_ && !frame.is_expansion()) {
    report(Severity::error, comment_begun_, end + " inside this .COMMENT", "'" + std::string(1, *comment_end_) + "' again");
    comment_end_.reset();
  }
  frames_.pop_back();
}

// Symbols

// The declaration that would make an unknown name known from another source; empty if no source defines it.
std::string I8080Pass::suggest_declaration(const std::string& name) const {
  if (!engine_.names_are_local()) return {};
  const auto of = [&](const Symbol& symbol) { return engine_.file(symbol.defined.file).name; };
  const auto defined = [&](std::optional<std::size_t> source) {
    const Symbol* const found = engine_.find_in(name, source);
    return found != nullptr && found->defined_in_pass != 0 ? found : nullptr;
  };
  if (const Symbol* const common = defined(std::nullopt)) return "EXTRN " + common->name + ": " + of(*common) + " defines it";
  for (std::size_t source = 0; source < engine_.sources(); ++source) {
    const Symbol* const found = defined(source);
    if (found == nullptr) continue;
    return "PUBLIC " + found->name + " in " + of(*found) + (engine_.declares() && !engine_.is_declared(name) ? ", and EXTRN here" : "");
  }
  return {};
}

void I8080Pass::warn_about_undefined_publics() {
  for (const auto& [name, at] : publics_) {
    const Symbol* const found = engine_.find_in(name, std::nullopt);
    if (found == nullptr || !engine_.is_defined(*found))
      report(Severity::warning, at, "public symbol " + quoted(name) + " without a definition", "one in this source");
  }
}

void I8080Pass::enter(std::string_view name, std::size_t at, SymbolKind kind, const I8080Value& value, bool any_word) {
  const std::string key = key_of(name, rules_);
  const Word* const reserved = find_word(key);
  const bool precedes = reserved != nullptr && reserved->kind == WordKind::operation && is_prefix(reserved->operation);
  if (reserved != nullptr && reserved->kind != WordKind::directive && (!any_word || precedes)) {
    return error(at, quoted(name), "a name that is no register, operator or instruction");
  }
  Symbol& symbol = engine_.symbol(key, name);
  if (symbol.kind == SymbolKind::define) {
    if (kind == SymbolKind::label) error(at, "label " + quoted(name), "another name: -D defines this one");
    return;
  }
  const bool again = engine_.is_defined(symbol);
  const std::uint32_t bits = value.bits & 0xFFFFU;
  if (again && (kind != SymbolKind::assigned || symbol.kind != kind)) {
    const bool equal = kind == symbol.kind && value.known && symbol.value == bits;
    return report(equal ? Severity::warning : Severity::error, place(at),
                  "a second definition of " + quoted(name) + (equal ? " with the same value" : ""), "one, at " + engine_.where(symbol.defined));
  }
  if (!again && rules_.significant != 0 && key.size() > rules_.significant) {
    warning(at, quoted(name) + " of " + std::to_string(key.size()) + " characters",
            "at most " + std::to_string(rules_.significant) + ", which are all that count with --dialect " +
                std::string(i8080_dialect_names[static_cast<std::size_t>(rules_.dialect)]));
  }
  engine_.define(symbol, kind, value.known ? std::optional(bits) : std::nullopt, place(at),
                 (value.forward ? forward_form : 0) | (value.pattern ? pattern_form : 0));
}

// Bytes

void I8080Pass::emit(std::uint8_t byte) {
  if (location_ >= memory_end) {
    if (!reported_overflow_) error(0, "a byte past FFFF", "a program within 64K");
    reported_overflow_ = true;
    return;
  }
  const std::uint32_t address = location_++;
  if (!engine_.final()) return;
  made_bytes_ = true;
  I8080Frame& frame = *frames_.back();
  if (engine_.put(address, byte, frame.place(0), frame.listed) && !std::exchange(reported_overlap_, true))
    warning(0, "a second byte for address " + hexadecimal(address, 4), "one");
}

// `frame` is the frame of the statement, which may have pushed another.
void I8080Pass::end_statement(I8080Frame& frame) {
  if (engine_.final() && !made_bytes_ && shown_value_) engine_.show(frame.listed, *shown_value_, shown_equated_, frame.place(0));
}

// Tokens and messages

void I8080Pass::read_operands(std::size_t at) {
  lexer_ = I8080Lexer(statement_.text, at, rules_, radix_);
  nesting_ = 0;
  advance();
}

bool I8080Pass::expect_end() {
  if (at_end()) return true;
  unexpected("the end of the statement");
  return false;
}

bool I8080Pass::expect_comma() {
  if (!token_.is(',')) {
    unexpected("','");
    return false;
  }
  advance();
  return true;
}

std::string I8080Pass::shown_token() const {
  return at_end() ? "the end of the statement" : quoted(token_.text);
}

void I8080Pass::unexpected(std::string expected) {
  error(token_.column, shown_token(),
        token_.kind == I8080TokenKind::bad ? token_.value
        : token_.is('!') && !rules_.bang_separates
            ? expected + "; --dialect mac separates statements with `!`"
            : std::move(expected));
}

Position I8080Pass::place(std::size_t at) const {
  return frames_.back()->place(statement_.offset + at);
}

void I8080Pass::error(std::size_t at, std::string found, std::string expected) {
  if (engine_.final()) report(Severity::error, place(at), std::move(found), std::move(expected));
}

void I8080Pass::warning(std::size_t at, std::string found, std::string expected) {
  if (engine_.final()) report(Severity::warning, place(at), std::move(found), std::move(expected));
}

// Inside an expansion the position is in the macro's text, and the position of the call follows it.
std::string I8080Pass::where_from() const {
  std::string text;
  std::size_t shown = 0;
  for (auto frame = frames_.rbegin(); frame != frames_.rend() && (*frame)->is_expansion(); ++frame) {
    if (++shown > most_places_shown) return text + ", ...)";
    const Position called = (*frame)->called();
    text += (text.empty() ? " (in " : ", in ") + (*frame)->name() + " at " +
            engine_.where(called);
  }
  return text.empty() ? text : text + ")";
}

void I8080Pass::report(Severity severity, const Position& at, std::string found, std::string expected) {
  if (engine_.final()) engine_.report(severity, at, std::move(found), std::move(expected) + where_from());
}

}  // namespace sightline::assembler
