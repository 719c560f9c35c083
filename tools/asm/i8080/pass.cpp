#include "tools/asm/i8080/pass.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "tools/image/binary.hpp"

namespace sightline::assembler {
namespace {

using image::hexadecimal;

constexpr std::size_t most_errors = 1000;       // the same limit for warnings
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

void I8080Pass::run(std::size_t sources) {
  program_.unknown_values = 0;
  program_.values_changed = false;
  for (std::size_t file = 0; file < sources && !stopped_; ++file) {
    source_ = file;
    radix_ = 10;
    push(std::make_unique<I8080Frame>(file, program_.files[file].text, rules_));
    while (!frames_.empty() && !stopped_) {
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
  forget_vanished();
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
    stopped_ = true;
  }
  begin_row();
  return true;
}

void I8080Pass::count_lines(std::size_t more) {
  lines_ += more;
  if (lines_ <= options_.most_lines) return;
  error(0, "more than " + std::to_string(options_.most_lines) + " lines with all expansions",
        "repeats and macros that end");
  stopped_ = true;
}

void I8080Pass::begin_row() {
  if (!final_ || !options_.listing) return;
  I8080Frame& frame = *frames_.back();
  frame.row = program_.listing.size();
  frame.row_filled = false;
  program_.listing.push_back({"", "", (frame.is_expansion() ? "+" : "") + std::string(frame.line())});
}

void I8080Pass::end_of_frame() {
  const I8080Frame& frame = *frames_.back();
  const std::string end =
      frame.is_expansion() ? "the end of " + frame.name() : "the end of " + program_.files[frame.file()].name;
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

// The separator is a line break, which no name contains.
std::string I8080Pass::scoped(const std::string& name) const {
  if (!program_.modules_known) return name;
  const I8080Module& module = program_.modules[source_];
  if (!module.declares || module.shared.contains(name)) return name;
  const auto found = program_.symbols.find(name);
  const bool defined = found != program_.symbols.end() && found->second.kind == I8080SymbolKind::define && found->second.value;
  return defined ? name : name + "\n" + std::to_string(source_);
}

// Forgets symbols that only the pass before defined, because an IF had another value in it. What IF1 defines stays in the last
// pass.
void I8080Pass::forget_vanished() {
  if (final_) {
    if (program_.vanished && errors_ == 0)
      report(Severity::error, *program_.vanished, "a definition that is in every second pass", "an IF that does not depend on it");
    return;
  }
  program_.vanished.reset();
  for (auto& [key, entry] : program_.symbols) {
    if (entry.defined_in_pass == 0 || entry.defined_in_pass == number_) continue;
    program_.vanished = entry.defined;
    program_.values_changed = true;
    entry.value.reset();
    entry.defined_in_pass = 0;
  }
}

void I8080Pass::share(const std::string& name) {
  I8080Module& module = program_.modules[source_];
  module.declares = true;
  module.shared.insert(name);
}

// The declaration that would make an unknown name known from another source; empty if no source defines it.
std::string I8080Pass::suggest_declaration(const std::string& name) const {
  if (!program_.modules_known) return {};
  const bool declares = program_.modules[source_].declares && !program_.modules[source_].shared.contains(name);
  const auto of = [&](const I8080Entry& entry) { return program_.files[entry.defined.file].name; };
  const auto global = program_.symbols.find(name);
  if (global != program_.symbols.end() && global->second.defined_in_pass != 0)
    return "EXTRN " + global->second.name + ": " + of(global->second) + " defines it";
  for (std::size_t source = 0; source < program_.modules.size(); ++source) {
    const auto found = program_.symbols.find(name + "\n" + std::to_string(source));
    if (found == program_.symbols.end() || found->second.defined_in_pass == 0) continue;
    return "PUBLIC " + found->second.name + " in " + of(found->second) + (declares ? ", and EXTRN here" : "");
  }
  return {};
}

void I8080Pass::warn_about_undefined_publics() {
  for (const Public& each : publics_) {
    const auto found = program_.symbols.find(each.name);
    if (found == program_.symbols.end() || found->second.defined_in_pass != number_)
      report(Severity::warning, each.at, "public symbol " + quoted(each.name) + " without a definition", "one in this source");
  }
}

void I8080Pass::enter(std::string_view name, std::size_t at, I8080SymbolKind kind, const I8080Value& value,
                      bool any_word) {
  const std::string key = key_of(name, rules_);
  const Word* const reserved = program_.vocabulary.find(key);
  const bool precedes = reserved != nullptr && reserved->kind == WordKind::operation && is_prefix(reserved->operation);
  if (reserved != nullptr && reserved->kind != WordKind::directive && (!any_word || precedes)) {
    return error(at, quoted(name), "a name that is no register, operator or instruction");
  }
  I8080Entry& entry = program_.symbols[scoped(key)];
  if (entry.name.empty()) entry.name = std::string(name);
  if (entry.kind == I8080SymbolKind::define && entry.value) {
    if (kind == I8080SymbolKind::label)
      error(at, "label " + quoted(name), "another name: -D defines this one");
    return;
  }
  const bool again = entry.defined_in_pass == number_;
  const auto bits = static_cast<std::uint16_t>(value.bits);
  if (again && kind == entry.kind && kind != I8080SymbolKind::set && value.known && entry.value == bits) {
    return warning(at, "a second definition of " + quoted(name) + " with the same value",
                   "one, at " + program_.files[entry.defined.file].name + ":" + std::to_string(entry.defined.line));
  }
  if (!again && rules_.significant != 0 && key.size() > rules_.significant) {
    warning(at, quoted(name) + " of " + std::to_string(key.size()) + " characters",
            "at most " + std::to_string(rules_.significant) + ", which are all that count with --dialect " +
                std::string(i8080_dialect_names[static_cast<std::size_t>(rules_.dialect)]));
  }
  if (again && (kind != I8080SymbolKind::set || entry.kind != kind)) {
    return error(
        at, "a second definition of " + quoted(name),
        "one, at " + program_.files[entry.defined.file].name + ":" + std::to_string(entry.defined.line));
  }
  const std::optional<std::uint16_t> now =
      value.known ? std::optional(static_cast<std::uint16_t>(value.bits)) : std::nullopt;
  if (kind != I8080SymbolKind::set && number_ > 1 && entry.value != now) {
    program_.values_changed = true;
    if (now && entry.value && !reported_phase_error_) {
      error(at, quoted(name) + " = " + hexadecimal(*now, 4),
            hexadecimal(*entry.value, 4) + " as in the pass before (phase error)");
      reported_phase_error_ = final_;
    }
  }
  if (!value.known) ++program_.unknown_values;
  if (!again) entry.defined = place(at);
  entry.kind = kind;
  entry.value = now;
  entry.forward = value.forward;
  entry.pattern = value.pattern;
  entry.defined_in_pass = number_;
}

// Bytes

void I8080Pass::emit(std::uint8_t byte) {
  if (location_ >= memory_end) {
    if (!reported_overflow_) error(0, "a byte past FFFF", "a program within 64K");
    reported_overflow_ = true;
    return;
  }
  const auto address = static_cast<std::uint16_t>(location_++);
  if (!final_) return;
  if (program_.image.used(address) && !reported_overlap_) {
    warning(0, "a second byte for address " + hexadecimal(address, 4), "one");
    reported_overlap_ = true;
  }
  program_.image.put(address, byte);
  bytes_.push_back(byte);
}

// `frame` is the frame of the statement, which may have pushed another.
void I8080Pass::end_statement(I8080Frame& frame) {
  if (!final_ || !frame.row || (bytes_.empty() && (!shown_value_ || frame.row_filled))) return;
  std::size_t shown = 0;
  do {
    const std::size_t count = std::min(bytes_.size() - shown, listing_bytes_a_row);
    const std::uint32_t first =
        bytes_.empty() ? *shown_value_ : statement_location_ + static_cast<std::uint32_t>(shown);
    std::string code = shown_equated_ ? "=" : "";
    for (std::size_t i = 0; i < count; ++i) code += hexadecimal(bytes_[shown + i], 2);
    if (frame.row_filled) program_.listing.push_back({"", "", ""});
    ListingLine& line = frame.row_filled ? program_.listing.back() : program_.listing[*frame.row];
    line.address = hexadecimal(first, 4);
    if (!shown_equated_ && !frame.row_filled) {
      const Position place = frame.place(0);
      line.file = program_.files[place.file].name;
      line.line_number = place.line;
    }
    line.code = std::move(code);
    frame.row_filled = true;
    shown += count;
  } while (shown < bytes_.size());
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
  if (final_) report(Severity::error, place(at), std::move(found), std::move(expected));
}

void I8080Pass::warning(std::size_t at, std::string found, std::string expected) {
  if (final_) report(Severity::warning, place(at), std::move(found), std::move(expected));
}

// Inside an expansion the position is in the macro's text, and the position of the call follows it.
std::string I8080Pass::where_from() const {
  std::string text;
  std::size_t shown = 0;
  for (auto frame = frames_.rbegin(); frame != frames_.rend() && (*frame)->is_expansion(); ++frame) {
    if (++shown > most_places_shown) return text + ", ...)";
    const Position called = (*frame)->called();
    text += (text.empty() ? " (in " : ", in ") + (*frame)->name() + " at " +
            program_.files[called.file].name + ":" + std::to_string(called.line);
  }
  return text.empty() ? text : text + ")";
}

void I8080Pass::report(Severity severity, const Position& at, std::string found, std::string expected) {
  if (!final_ || stopped_) return;
  const auto& name = program_.files[at.file].name;
  const bool is_error = severity == Severity::error;
  std::size_t& count = is_error ? errors_ : warnings_;
  if (count > most_errors) return;
  if (++count > most_errors) {
    program_.diagnostics.push_back(
        {severity, name, at.line, at.column,
         "more than " + std::to_string(most_errors) + (is_error ? " errors" : " warnings"),
         is_error ? "fewer; the rest is not read" : "fewer; the rest is not shown"});
    stopped_ = is_error;
    return;
  }
  program_.diagnostics.push_back(
      {severity, name, at.line, at.column, std::move(found), std::move(expected) + where_from()});
}

}  // namespace sightline::assembler
