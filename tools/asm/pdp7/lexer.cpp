#include "tools/asm/pdp7/lexer.hpp"

namespace sightline::assembler {
namespace {

bool letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

TokenKind punctuation(char c) {
  switch (c) {
    case '.': return TokenKind::dot;
    case '+': return TokenKind::plus;
    case '-': return TokenKind::minus;
    case '!': return TokenKind::bang;
    case '&': return TokenKind::ampersand;
    case '(': return TokenKind::open;
    case ')': return TokenKind::close;
    case ',': return TokenKind::comma;
    case '=': return TokenKind::equals;
    case '/': return TokenKind::origin;
    case '#':
    case '$': return TokenKind::hash;
    case '<': return TokenKind::less;
    case '>': return TokenKind::greater;
    case ';': return TokenKind::semicolon;
    case '\n': return TokenKind::newline;
    default: return TokenKind::bad;
  }
}

bool ends_a_term(TokenKind kind) {
  return kind == TokenKind::name || kind == TokenKind::number || kind == TokenKind::dot ||
         kind == TokenKind::close || kind == TokenKind::hash;
}

}  // namespace

bool DecLexer::skip_blanks_and_comment() {
  const std::size_t start = at_;
  while (at_ < text_.size() && is_pdp7_blank(text_[at_])) ++at_;
  if (peek() == '/' && (at_ != start || !after_term_)) skip_line();
  return at_ != start;
}

void DecLexer::skip_line() {
  while (at_ < text_.size() && text_[at_] != '\n') ++at_;
}

Token DecLexer::take(TokenKind kind, std::size_t length, bool after_blank) {
  const Token token{kind, text_.substr(at_, length), position(), after_blank};
  at_ += length;
  after_term_ = ends_a_term(kind);
  if (kind == TokenKind::newline) {
    ++line_;
    line_start_ = at_;
  }
  return token;
}

Token DecLexer::next() {
  const bool after_blank = skip_blanks_and_comment();
  if (at_ == text_.size()) return take(TokenKind::end, 0, after_blank);
  const char first = text_[at_];
  if (!letter(first) && !is_pdp7_digit(first)) return take(punctuation(first), 1, after_blank);
  std::size_t length = 1;
  while (at_ + length < text_.size() && (letter(text_[at_ + length]) || is_pdp7_digit(text_[at_ + length]))) ++length;
  return take(letter(first) ? TokenKind::name : TokenKind::number, length, after_blank);
}

Token DecLexer::delimited() {
  while (at_ < text_.size() && is_pdp7_blank(text_[at_])) ++at_;
  const char delimiter = peek();
  const std::size_t line_end = std::min(text_.find('\n', at_), text_.size());
  const std::size_t closing = at_ < line_end ? text_.find(delimiter, at_ + 1) : std::string_view::npos;
  if (closing >= line_end) return take(TokenKind::bad, line_end - at_, true);
  ++at_;
  const Token inside = take(TokenKind::name, closing - at_, true);
  ++at_;
  return inside;
}

}  // namespace sightline::assembler
