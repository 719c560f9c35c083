#include <string>

#include "emulators/core/word.hpp"
#include "host/base/number.hpp"
#include "tools/asm/pdp7/dec.hpp"

namespace sightline::assembler {
namespace {

constexpr int deepest_literal = 16;  // literals inside literals; deeper nesting is an error in the source
constexpr std::string_view a_term = "a number, a name, '.' or '('";

// The dialect that an undefined name suggests, as text for the message.
std::string dialect_of(std::string_view name) {
  const std::string lower = lower_case(name.substr(0, 6));
  if (lower == "sys") return ", a system call of --dialect bell";
  return lower == "disp" || lower == "nodisp" ? ", a pseudo-operation of the Cambridge dialect" : "";
}

}  // namespace

bool DecPass::starts_a_term() const {
  switch (token_.kind) {
    case TokenKind::name:
    case TokenKind::number:
    case TokenKind::dot:
    case TokenKind::hash: return token_.after_blank;
    case TokenKind::open: return true;
    default: return false;
  }
}

std::optional<Value> DecPass::expression() {
  std::optional<Value> left = term();
  while (left) {
    const Position at = token_.at;
    const TokenKind kind = token_.kind;
    const bool is_operator = kind == TokenKind::plus || kind == TokenKind::minus || kind == TokenKind::bang ||
                             kind == TokenKind::ampersand;
    if (!is_operator && !starts_a_term()) return left;
    if (is_operator) advance();
    const std::optional<Value> right = term();
    if (!right) return std::nullopt;
    switch (kind) {
      case TokenKind::minus: left = arithmetic_.difference(*left, *right); break;
      case TokenKind::bang: left = arithmetic_.logical(*left, *right, false); break;
      case TokenKind::ampersand: left = arithmetic_.logical(*left, *right, true); break;
      default: left = arithmetic_.combine(*left, *right, at); break;
    }
  }
  return left;
}

std::optional<Value> DecPass::term() {
  bool negative = false;
  bool sign = false;
  for (; token_.kind == TokenKind::plus || token_.kind == TokenKind::minus; advance()) {
    negative ^= token_.kind == TokenKind::minus;
    sign = true;
  }
  std::optional<Value> value = primary();
  if (value && negative) value = arithmetic_.negative(*value);
  if (value && sign) value->bare_number = false;
  return value;
}

std::optional<Value> DecPass::primary() {
  switch (token_.kind) {
    case TokenKind::number: return number();
    case TokenKind::name:
    case TokenKind::hash: return symbol();
    case TokenKind::open: return literal();
    case TokenKind::dot: advance(); return Value::number(location_);
    default: break;
  }
  const bool of_pal = token_.kind == TokenKind::bad && token_.text == "*";
  error(token_.at, found_here() + (of_pal ? ", which sets the location in PAL of the PDP-8" : ""), std::string(a_term));
  return std::nullopt;
}

std::optional<Value> DecPass::number() {
  const Token token = token_;
  advance();
  const char highest = decimal_ ? '9' : '7';
  std::uint32_t n = 0;
  if (token.text.size() == 2 && (token.text[1] == 'f' || token.text[1] == 'b')) {
    error(token.at, describe(token) + ", a relative label of --dialect bell", "a tag with a name");
    return std::nullopt;
  }
  for (const char c : token.text) {
    if (c < '0' || c > highest) {
      error(token.at, "'" + std::string(1, c) + "' in number " + describe(token),
            decimal_ ? "decimal digits" : "octal digits (DECIMAL reads 8 and 9)");
      return std::nullopt;
    }
    n = n * (decimal_ ? 10U : 8U) + static_cast<std::uint32_t>(c - '0');
    if (n > core::Word18::mask) {
      error(token.at, "number " + describe(token),
            decimal_ ? "at most 262143, which is 18 bits" : "at most 777777, which is 18 bits");
      return std::nullopt;
    }
  }
  Value value = Value::number(n);
  value.bare_number = true;
  return value;
}

// name, #name or name#, with # or $
std::optional<Value> DecPass::symbol() {
  bool marked = token_.kind == TokenKind::hash;
  if (marked) advance();
  if (token_.kind != TokenKind::name) {
    error(token_.at, describe(token_), "the name of a variable after '#'");
    return std::nullopt;
  }
  const Token name = token_;
  advance();
  if (token_.kind == TokenKind::hash && !token_.after_blank) {
    marked = true;
    advance();
  }
  Symbol& found = look_up(name);
  if (marked) mark_variable(found, name);
  if (found.kind == SymbolKind::undefined) {
    const bool external = engine_.means_external(engine_.naming().key(name.text));
    if (!options_.undefined_are_variables && !external) {  // an undeclared external is reported at its declaration
      error(name.at, "undefined symbol " + describe(name) + dialect_of(name.text),
            "a tag, an assignment, or #" + std::string(name.text));
    }
    return Value::unknown();
  }
  if (found.set_again && !engine_.is_defined(found)) {
    error(name.at, "symbol " + describe(name) + " before its first assignment",
          "an earlier assignment, because it is assigned several values");
  }
  const bool of_source = found.kind == SymbolKind::label || found.kind == SymbolKind::assigned ||
                         found.kind == SymbolKind::variable;
  if (in_condition_ && of_source && !engine_.is_defined(found)) {
    error(name.at, "symbol " + describe(name) + " in a condition before its definition",
          "a symbol defined before, or by -D");
    return Value::unknown();
  }
  if (found.value) return from_symbol(*found.value, static_cast<Form>(found.form));
  error(name.at, "symbol " + describe(name) + " without a value",
        "a definition that does not depend on itself");
  return Value::unknown();
}

void DecPass::mark_variable(Symbol& symbol, const Token& name) {
  if (symbol.kind == SymbolKind::undefined) {
    symbol.kind = SymbolKind::variable;
    symbol.defined = name.at;
  }
  if (symbol.kind != SymbolKind::variable) {
    return error(name.at, "'#' at symbol " + describe(name) + ", which is defined otherwise", "another name for the variable");
  }
  const std::string key = engine_.table_key(engine_.naming().key(name.text));
  if (!placed_variables_.contains(key)) pending_variables_.insert(key);
}

std::optional<Value> DecPass::literal() {
  const Position at = token_.at;
  if (nesting_ == deepest_literal) {
    error(at, "a literal nested more than " + std::to_string(deepest_literal) + " deep", "fewer parentheses");
    return std::nullopt;
  }
  ++nesting_;
  advance();
  const Position inside = token_.at;
  const std::optional<Value> content = expression();
  --nesting_;
  if (!content) return std::nullopt;
  if (token_.kind == TokenKind::close) advance();
  const std::uint32_t word = word_of(*content, inside);
  const std::uint32_t index = literal_index(content->known ? std::optional(word) : std::nullopt);
  const auto pool = engine_.places(0).next();
  return pool ? Value::number((*pool + index) & image::last_address) : Value::unknown();
}

// An unknown literal may turn out to be equal to another.
std::uint32_t DecPass::literal_index(std::optional<std::uint32_t> word) {
  const auto next = static_cast<std::uint32_t>(pool_.size());
  if (word) {
    const auto [place, added] = pool_index_.try_emplace(*word, next);
    if (!added) return place->second;
  } else {
    engine_.await_value();
  }
  pool_.push_back(word.value_or(0));
  return next;
}

std::optional<std::uint32_t> DecPass::address_of(const Value& value, const Position& at,
                                                  std::string_view what, const char* hint) {
  if (!value.known) return std::nullopt;
  const std::uint32_t address = word_of(value, at);
  if (address <= image::last_address) return address;
  error(at, std::string(what) + " " + base::octal(address, 6),
        std::string("an address from 00000 to 77777") + hint);
  return std::nullopt;
}

}  // namespace sightline::assembler
