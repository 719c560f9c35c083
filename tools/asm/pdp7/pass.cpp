#include "tools/asm/pdp7/pass.hpp"

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
  std::string text = "'";
  for (const char c : token.text.substr(0, 40)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= ' ' && byte < 0177) {
      text += c;
    } else {
      text += "\\" + base::octal(byte, 3);
    }
  }
  return text + (token.text.size() > 40 ? "...'" : "'");
}

Pdp7Pass::Pdp7Pass(std::span<const SourceFile> sources, const Options& options, Pdp7Program& program,
                   int number, bool final)
    : sources_(sources),
      options_(options),
      program_(program),
      number_(number),
      final_(final),
      arithmetic_(options.twos_complement) {}

void Pdp7Pass::run() {
  program_.start.reset();
  Position end;
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    read_file(i);
    end = token_.at;
  }
  if (final_) report_undefined_declarations();
  if (options_.undefined_are_variables) {
    for (auto& [key, symbol] : program_.symbols) {
      if (program_.externals.contains(key)) continue;
      if (symbol.kind == SymbolKind::undefined) symbol.kind = SymbolKind::variable;
      if (symbol.kind == SymbolKind::variable && !placed_variables_.contains(key))
        pending_variables_.insert(key);
    }
  }
  place_literals(end);
  place_variables(end);
}

void Pdp7Pass::read_file(std::size_t index) {
  source_ = index;
  lexer_ = Pdp7Lexer(sources_[index].text, index);
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

Token Pdp7Pass::following() const {
  Pdp7Lexer ahead = lexer_;
  return ahead.next();
}

bool Pdp7Pass::at_end_of_statement() const {
  return token_.kind == TokenKind::newline || token_.kind == TokenKind::semicolon ||
         token_.kind == TokenKind::end || token_.kind == TokenKind::greater;
}

void Pdp7Pass::skip_statement() {
  while (!at_end_of_statement()) advance();
}

// Statements are separated by the end of a line, `;`, or the `>` of an open conditional.
void Pdp7Pass::end_statement() {
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

void Pdp7Pass::statement() {
  while (!at_end_of_statement()) {
    if (token_.kind == TokenKind::name) {
      const Token next = following();
      if (next.kind == TokenKind::comma && !next.after_blank) {
        define_tag(token_, location_, 0);
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
      const auto address = address_of(*value, at, "a '/' straight after the word",
                                      " (a comment needs a blank before its '/')");
      location_ = address.value_or(location_);
      if (value->known && !address) lexer_.skip_line();  // the `/` was meant to begin a comment
      location_by_origin_ = true;
    }
    advance();
  }
}

void Pdp7Pass::define_tag(Token name, std::uint32_t value, int form) {
  Symbol& symbol = look_up(name);
  const bool again =
      symbol.kind == SymbolKind::tag && (symbol.defined != name.at || symbol.defined_in_pass == number_);
  if (symbol.kind == SymbolKind::permanent) {
    error(name.at, "permanent symbol " + describe(name) + " as a tag", "another name");
    return;
  }
  if (again || (symbol.kind != SymbolKind::undefined && symbol.kind != SymbolKind::tag)) {
    const std::string where = symbol.defined.line == 0 ? "the command line"
                                                       : sources_[symbol.defined.file].name + ":" +
                                                             std::to_string(symbol.defined.line);
    error(name.at, "symbol " + describe(name) + ", already defined at " + where, "another name");
    return;
  }
  if (final_ && symbol.value != value) {
    error(name.at, "tag " + describe(name) + " at another address than in the pass before",
          "addresses that do not depend on themselves");
  }
  symbol.kind = SymbolKind::tag;
  symbol.defined = name.at;
  symbol.value = value;
  symbol.form = form;
  symbol.defined_in_pass = number_;
}

// name=expression, defines a tag whose value is the expression and the location: of `cdr=jms, 0` the word `cdr` is a
// call. The form is that of the Cambridge assembler of 1972.
bool Pdp7Pass::assign(Token name) {
  advance();
  advance();
  const Position at = token_.at;
  const std::optional<Value> value = expression();
  if (!value) {
    skip_statement();
    return false;
  }
  if (token_.kind == TokenKind::comma) {
    std::vector<Remark> remarks;
    Value here = arithmetic_.combine(*value, Value::number(location_), remarks);
    remark(at, remarks);
    define_tag(name, word_of(here, at), static_cast<int>(here.form));
    advance();
    return true;
  }
  const std::uint32_t word = word_of(*value, at);
  const bool names_microinstruction = value->bare_number && form_of_instruction(word) == Form::micro;
  const Form form = names_microinstruction ? Form::micro : value->form;
  Symbol& symbol = look_up(name);
  if (symbol.kind == SymbolKind::define) return false;
  if (symbol.kind == SymbolKind::tag || symbol.kind == SymbolKind::variable) {
    error(name.at,
          "an assignment to " + describe(name) + ", which is a " +
              (symbol.kind == SymbolKind::tag ? "tag" : "variable"),
          "another name");
    return false;
  }
  if (symbol.kind == SymbolKind::permanent && symbol.value != word) symbol.was_permanent = true;
  if (symbol.was_permanent) {
    warning(name.at, "an assignment to permanent symbol " + describe(name), "another name");
  }
  const bool first_in_pass = symbol.defined_in_pass != number_;
  if (!first_in_pass && value->known && symbol.value && symbol.value != word) symbol.several_values = true;
  if (final_ && first_in_pass && !symbol.several_values && symbol.value != word) {
    error(name.at, "symbol " + describe(name) + " with another value than in the pass before",
          "a definition that does not depend on itself");
  }
  if (first_in_pass) symbol.defined = name.at;
  symbol.kind = SymbolKind::assigned;
  symbol.value = value->known ? std::optional(word) : std::nullopt;
  symbol.form = static_cast<int>(form);
  symbol.defined_in_pass = number_;
  return false;
}

void Pdp7Pass::emit(std::uint32_t word, const Position& at, std::string generated_source) {
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
  if (final_) {
    const auto [place, added] = occupied_.try_emplace(location_, at);
    if (!added) {
      const Position& first = place->second;
      warning(at,
              "a second word at " + base::octal(location_, 5) + ", which replaces that of " +
                  sources_[first.file].name + ":" + std::to_string(first.line),
              "one word per address");
    }
    program_.words.push_back({at, location_, word, std::move(generated_source)});
  }
  ++location_;
}

void Pdp7Pass::place_literals(const Position& at) {
  if (program_.pool_bases.size() <= pools_placed_) program_.pool_bases.resize(pools_placed_ + 1);
  program_.pool_bases[pools_placed_++] = location_;
  for (const Literal& literal : pool_) emit(literal.word, at, "(" + base::octal(literal.word, 6) + ")");
  pool_.clear();
  pool_index_.clear();
}

void Pdp7Pass::place_variables(const Position& at) {
  for (const std::string& key : pending_variables_) {
    Symbol& symbol = program_.symbols.at_key(key);
    symbol.value = location_;
    symbol.defined_in_pass = number_;
    emit(0, at, symbol.name + ",");
    placed_variables_.insert(key);
  }
  pending_variables_.clear();
}

std::string Pdp7Pass::found_here() const {
  const std::string shown = describe(token_);
  if (token_.kind == TokenKind::less) return shown + ", which begins a character in --dialect bell";
  if (token_.kind == TokenKind::comma) return shown + ", which is this location in the Cambridge dialect";
  if (token_.kind != TokenKind::bad) return shown;
  if (token_.text == "\"") return shown + ", which begins a comment in --dialect bell";
  if (token_.text == ":") return shown + ", which ends a label in --dialect bell";
  return shown;
}

// Symbols of the machine and of -D are common to all sources.
bool Pdp7Pass::is_own(std::string_view name) {
  if (!program_.modules_known || !program_.modules[source_].declares) return false;
  if (program_.modules[source_].shared.contains(program_.symbols.key(name))) return false;
  const Symbol* const of_all = program_.symbols.find(name);
  return of_all == nullptr ||
         (of_all->kind != SymbolKind::permanent && of_all->kind != SymbolKind::define && !of_all->was_permanent);
}

Symbol& Pdp7Pass::look_up(const Token& name) {
  Symbol& symbol = is_own(name.text) ? program_.symbols.own(name.text, source_) : program_.symbols[name.text];
  if (final_ && (name.text.size() > 6 || symbol.name.size() > 6) &&
      lower_case(name.text) != lower_case(symbol.name) && clashes_.insert(lower_case(name.text)).second) {
    warning(name.at, describe(name) + ", the same symbol as '" + symbol.name + "'",
            "names that differ in their first six characters");
  }
  return symbol;
}

void Pdp7Pass::report(Severity severity, const Position& at, std::string found, std::string expected) {
  if (!final_) return;
  program_.diagnostics.emplace_back(at, Diagnostic{severity, sources_[at.file].name, at.line, at.column,
                                                   std::move(found), std::move(expected)});
}

void Pdp7Pass::error(const Position& at, std::string found, std::string expected) {
  report(Severity::error, at, std::move(found), std::move(expected));
}

void Pdp7Pass::warning(const Position& at, std::string found, std::string expected) {
  report(Severity::warning, at, std::move(found), std::move(expected));
}

void Pdp7Pass::remark(const Position& at, std::span<const Remark> remarks) {
  for (const Remark& r : remarks) report(r.severity, at, r.found, r.expected);
}

}  // namespace sightline::assembler
