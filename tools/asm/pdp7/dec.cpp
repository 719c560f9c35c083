#include "tools/asm/pdp7/dec.hpp"

#include <utility>

#include "host/base/number.hpp"
#include "tools/image/core_image.hpp"

namespace sightline::assembler {

std::string describe(const Token& token) {
  switch (token.kind) {
    case TokenKind::newline: return "the end of the line";
    case TokenKind::end: return "the end of the file";
    default: break;
  }
  return in_quotes(token.text);
}

void DecPass::run() {
  program_.start.reset();
  Position end;
  for (std::size_t i = 0; i < engine_.sources(); ++i) {
    read_file(i);
    end = token_.at;
  }
  report_undefined_declarations();
  if (options_.undefined_are_variables) {
    for (auto& [key, symbol] : engine_.symbols()) {
      if (engine_.is_external(key)) continue;
      if (symbol.kind == SymbolKind::undefined) symbol.kind = SymbolKind::variable;
      if (symbol.kind == SymbolKind::variable && !placed_variables_.contains(key)) pending_variables_.insert(key);
    }
  }
  place_literals(end);
  place_variables(end);
  program_.end_source();
}

void DecPass::read_file(std::size_t index) {
  program_.begin_source(index);
  lexer_ = DecLexer(engine_.file(index).text, index);
  if (options_.first_line_is_title) lexer_.skip_line();
  decimal_ = false;
  file_ended_ = false;
  blocks_.clear();
  for (advance(); token_.kind != TokenKind::end && !file_ended_;) {
    statement_follows_ = false;
    statement();
    if (!file_ended_ && !statement_follows_) end_statement();
  }
  if (file_ended_) return;
  for (const Position& opened : blocks_)
    error(opened, "'<' that is never closed", "'>' before the end of the file");
}

Token DecPass::following() const {
  DecLexer ahead = lexer_;
  return ahead.next();
}

bool DecPass::at_end_of_statement() const {
  return token_.kind == TokenKind::newline || token_.kind == TokenKind::semicolon ||
         token_.kind == TokenKind::end || token_.kind == TokenKind::greater;
}

void DecPass::skip_statement() {
  while (!at_end_of_statement()) advance();
}

// Statements are separated by the end of a line, `;`, or the `>` of an open conditional.
void DecPass::end_statement() {
  if (!at_end_of_statement()) {
    error(token_.at, found_here(), "an operator or the end of the statement");
    skip_statement();
  }
  while (token_.kind == TokenKind::greater) {
    if (blocks_.empty()) {
      error(token_.at, "'>' without '<'", "the end of the statement");
    } else {
      blocks_.pop_back();
    }
    advance();
  }
  if (token_.kind == TokenKind::newline || token_.kind == TokenKind::semicolon) advance();
}

void DecPass::statement() {
  while (!at_end_of_statement()) {
    if (token_.kind == TokenKind::name) {
      const Token next = following();
      if (next.kind == TokenKind::comma && !next.after_blank) {
        define_tag(token_, location_);
        advance();
        advance();
        continue;
      }
      if (next.kind == TokenKind::equals) {
        if (!assign(token_)) return;
        continue;
      }
      if (pseudo_operation()) return;
    }
    const Position at = token_.at;
    if (token_.kind == TokenKind::dot && following().kind == TokenKind::equals) {
      error(at, "'.=', which sets the location in --dialect bell", "the address and a '/' straight after it");
      return skip_statement();
    }
    const std::optional<Value> value = expression();
    if (token_.kind != TokenKind::origin) {
      emit(value ? word_of(*value, at) : 0, at);
      if (!value) skip_statement();
      return;
    }
    if (value) {
      if (!value->known) engine_.await_value();
      const auto address = address_of(*value, at, "a '/' straight after the word",
                                      " (a comment needs a blank before its '/')");
      location_ = address.value_or(location_);
      if (value->known && !address) lexer_.skip_line();  // the `/` was meant to begin a comment
      location_by_origin_ = true;
    }
    advance();
  }
}

void DecPass::define_tag(const Token& name, std::optional<std::uint32_t> value, int form) {
  Symbol& symbol = look_up(name);
  if (symbol.kind == SymbolKind::permanent)
    return error(name.at, "permanent symbol " + describe(name) + " as a tag", "another name");
  if (symbol.kind != SymbolKind::undefined && (symbol.kind != SymbolKind::label || engine_.is_defined(symbol)))
    return error(name.at, "symbol " + describe(name) + ", already defined at " + engine_.where(symbol.defined), "another name");
  engine_.define(symbol, SymbolKind::label, value, name.at, form);
}

// name=expression, defines a tag whose value is the expression and the location: of `cdr=jms, 0` the word `cdr` is a
// call. The form is that of the Cambridge assembler of 1972.
bool DecPass::assign(Token name) {
  advance();
  advance();
  const Position at = token_.at;
  const std::optional<Value> value = expression();
  if (!value) {
    skip_statement();
    return false;
  }
  const auto known_word = [&](const Value& v) {
    const std::uint32_t word = word_of(v, at);
    return v.known ? std::optional(word) : std::nullopt;
  };
  if (token_.kind == TokenKind::comma) {
    const Value here = arithmetic_.combine(*value, Value::number(location_), at);
    define_tag(name, known_word(here), static_cast<int>(here.form));
    advance();
    return true;
  }
  const std::optional<std::uint32_t> word = known_word(*value);
  const bool names_microinstruction = value->bare_number && form_of_instruction(*word) == Form::micro;
  Symbol& symbol = look_up(name);
  if (symbol.kind == SymbolKind::define) return false;
  if (symbol.kind == SymbolKind::label || symbol.kind == SymbolKind::variable) {
    error(name.at,
          "an assignment to " + describe(name) + ", which is a " + (symbol.kind == SymbolKind::label ? "tag" : "variable"),
          "another name");
    return false;
  }
  if (symbol.kind == SymbolKind::permanent && symbol.value != word.value_or(0)) symbol.was_permanent = true;
  if (symbol.was_permanent)
    engine_.warning(name.at, "an assignment to permanent symbol " + describe(name), "another name");
  if (engine_.is_defined(symbol) && word && symbol.value && symbol.value != word) symbol.set_again = true;
  engine_.define(symbol, SymbolKind::assigned, word, name.at,
                 static_cast<int>(names_microinstruction ? Form::micro : value->form));
  return false;
}

void DecPass::emit(std::uint32_t word, const Position& at, std::string generated_source) {
  if (location_ > image::last_address) {
    if (location_ == image::last_address + 1)
      error(at, "a word after address 77777", "the end of the program");
    ++location_;
    return;
  }
  if (!location_by_origin_ && (location_ & image::field_mask) == 0) {
    error(at, "a word at " + base::octal(location_, 5) + " that runs over the end of its bank",
          "an origin for the next bank");
  }
  location_by_origin_ = false;
  if (engine_.final()) program_.put(at, location_, word, base::octal(location_, 5), "address", std::move(generated_source));
  ++location_;
}

void DecPass::place_literals(const Position& at) {
  engine_.places(0).add(location_);
  for (const std::uint32_t literal : pool_) emit(literal, at, "(" + base::octal(literal, 6) + ")");
  pool_.clear();
  pool_index_.clear();
}

void DecPass::place_variables(const Position& at) {
  for (const std::string& key : pending_variables_) {
    Symbol& symbol = engine_.symbols()[key];
    engine_.define(symbol, SymbolKind::variable, location_, symbol.defined);
    emit(0, at, symbol.name + ",");
    placed_variables_.insert(key);
  }
  pending_variables_.clear();
}

std::string DecPass::found_here() const {
  const std::string shown = describe(token_);
  if (token_.kind == TokenKind::less) return shown + ", which begins a character in --dialect bell";
  if (token_.kind == TokenKind::comma) return shown + ", which is this location in the Cambridge dialect";
  if (token_.kind != TokenKind::bad) return shown;
  if (token_.text == "\"") return shown + ", which begins a comment in --dialect bell";
  if (token_.text == ":") return shown + ", which ends a label in --dialect bell";
  return shown;
}

}  // namespace sightline::assembler
