// The pseudo-operations: statements that do more than make a word.
#include <array>
#include <utility>

#include "tools/asm/pdp7/dec.hpp"

namespace sightline::assembler {
namespace {

constexpr std::uint32_t minus_zero = 0777777;

// Trimmed ASCII: '@' to '_' are 00 to 37, blank to '?' are 40 to 77. Nothing for a character outside.
std::optional<std::uint32_t> trimmed_ascii(char c) {
  if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  if (c >= ' ' && c <= '_') return static_cast<std::uint32_t>(c) & 077U;
  return std::nullopt;
}

}  // namespace

std::string_view pseudo_operation_named(std::string_view word) {
  constexpr std::array<std::string_view, 14> names{"text",      "title",     "ifzero", "ifnzro",   "start",    "pause", "decimal", "octal",
                                                   "constants", "variables", "punch",  "external", "internal", "libfrm"};
  const std::string lower = lower_case(word.substr(0, 12));
  for (const std::string_view name : names) {
    const bool long_enough = lower.size() == name.size() || lower.size() >= 6;
    if (long_enough && word.size() <= name.size() && name.substr(0, lower.size()) == lower) return name;
  }
  return {};
}

bool DecPass::pseudo_operation() {
  const Position at = token_.at;
  const std::string_view name = pseudo_operation_named(token_.text);
  if (name.empty()) return false;
  if (name == "text") {
    text();
    return true;
  }
  if (name == "title") lexer_.skip_line();
  advance();
  if (name == "ifzero" || name == "ifnzro") conditional(name == "ifzero");
  if (name == "start") end_of_file();
  if (name == "pause") next_tape();
  if (name == "external" || name == "internal") declare(name == "external");
  if (name == "libfrm") {
    error(at, "LIBFRM, which asks DEC's Linking Loader for a library", "the library among the sources of the program");
    skip_statement();
  }
  if (name == "decimal" || name == "octal") decimal_ = name == "decimal";
  if (name == "constants") place_literals(at);
  if (name == "variables") place_variables(at);
  return true;
}

void DecPass::text() {
  const Position at = token_.at;
  const Token inside = lexer_.delimited();
  advance();
  if (inside.kind == TokenKind::bad) {
    return error(inside.at, "no text between two equal characters", "TEXT /characters/ on one line");
  }
  std::uint32_t word = 0;
  std::size_t filled = 0;
  for (std::size_t i = 0; i < inside.text.size(); ++i) {
    const auto code = trimmed_ascii(inside.text[i]);
    if (!code) {
      const Position place{inside.at.file, inside.at.line, inside.at.column + i};
      error(place, "character " + describe({TokenKind::bad, inside.text.substr(i, 1), place, false}),
            "one of trimmed ASCII: blank to '_', and letters");
    }
    word = word << 6 | code.value_or(0);
    if (++filled == 3) {
      emit(word, at);
      word = 0;
      filled = 0;
    }
  }
  if (filled != 0) emit(word << (6 * (3 - filled)), at);
}

void DecPass::conditional(bool when_zero) {
  const Position at = token_.at;
  in_condition_ = true;
  const std::optional<Value> value = expression();
  in_condition_ = false;
  if (value && !value->known) engine_.await_value();
  if (token_.kind != TokenKind::less) {
    if (value) error(token_.at, describe(token_), "'<' after the condition");
    return skip_statement();
  }
  const Position opened = token_.at;
  advance();
  const std::uint32_t word = value && value->known ? word_of(*value, at) : 0;
  const bool zero = word == 0 || (word == minus_zero && !options_.twos_complement);
  statement_follows_ = true;
  if (zero != when_zero) return skip_block(opened);
  blocks_.push_back(opened);
}

// Skips to after the `>` that closes the block. Comments and the strings of TEXT hold no brackets.
void DecPass::skip_block(const Position& opened) {
  bool at_start = true;
  for (int depth = 1; depth > 0;) {
    if (token_.kind == TokenKind::end) {
      return error(opened, "'<' that is never closed", "'>' before the end of the file");
    }
    if (at_start && token_.kind == TokenKind::name) {
      const std::string_view name = pseudo_operation_named(token_.text);
      const TokenKind next = following().kind;
      const bool defined = next == TokenKind::comma || next == TokenKind::equals;
      if (name == "text" && !defined) static_cast<void>(lexer_.delimited());
      if (name == "title" && !defined) lexer_.skip_line();
    }
    depth += token_.kind == TokenKind::less ? 1 : token_.kind == TokenKind::greater ? -1 : 0;
    at_start = token_.kind == TokenKind::newline || token_.kind == TokenKind::semicolon ||
               token_.kind == TokenKind::less || token_.kind == TokenKind::greater ||
               token_.kind == TokenKind::comma || token_.kind == TokenKind::origin;
    advance();
  }
}

// PAUSE ends a tape. Several tapes may have been copied into one file: the text after PAUSE is read like another file.
// Its first line is a title if those of the files are.
void DecPass::next_tape() {
  if (!at_end_of_statement()) {
    error(token_.at, describe(token_), "the end of the statement");
    return skip_statement();
  }
  decimal_ = false;
  if (!options_.first_line_is_title || token_.kind != TokenKind::newline) return;
  lexer_.skip_line();
  advance();
}

// EXTERNAL and INTERNAL of the FORTRAN assembly system (DIGITAL-7-3-S, appendix 3): names defined on other tapes, and
// names that other tapes use. All other names are local to the source. A declared name must be defined.
void DecPass::declare(bool external) {
  if (at_end_of_statement()) error(token_.at, describe(token_), "names");
  for (; !at_end_of_statement(); advance()) {
    if (token_.kind == TokenKind::comma) continue;
    if (token_.kind != TokenKind::name) {
      error(token_.at, describe(token_), "a name");
      return skip_statement();
    }
    if (look_up(token_).kind == SymbolKind::permanent)
      error(token_.at, "permanent symbol " + describe(token_), "another name");
    declared_.emplace_back(token_, external);
    engine_.declare(engine_.naming().key(token_.text), external);
  }
}

void DecPass::report_undefined_declarations() {
  for (const auto& [name, external] : declared_) {
    const Symbol* const symbol = engine_.find_in(engine_.naming().key(name.text), std::nullopt);
    if (symbol != nullptr && symbol->kind != SymbolKind::undefined) continue;
    error(name.at, (external ? "external symbol " : "internal symbol ") + describe(name) + ", which no source defines",
          external ? "the source that defines it on the command line, too: there is no linker" : "its definition");
  }
}

void DecPass::end_of_file() {
  const Position at = token_.at;
  file_ended_ = true;
  if (!at_end_of_statement()) {
    const std::optional<Value> value = expression();
    if (program_.start) error(at, "a second start address", "one START with an address");
    if (value) program_.start = address_of(*value, at, "start address");
  }
  if (!at_end_of_statement()) return error(token_.at, describe(token_), "the end of the statement");
  if (!blocks_.empty()) return;
  while (token_.kind == TokenKind::newline || token_.kind == TokenKind::semicolon) advance();
  if (token_.kind != TokenKind::end) {
    engine_.warning(token_.at, describe(token_) + " after START, which is not read",
            "the end of the file");
  }
}

}  // namespace sightline::assembler
