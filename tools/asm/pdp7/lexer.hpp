// Tokens of a PDP-7 source. A `/` straight after a term sets the location; any other begins a comment, which runs to
// the end of its line and is skipped here.
#pragma once

#include <cstdint>
#include <string_view>

#include "tools/asm/assembly.hpp"

namespace sightline::assembler {

// Characters that both dialects read alike.
[[nodiscard]] constexpr bool is_pdp7_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f'; }
[[nodiscard]] constexpr bool is_pdp7_digit(char c) { return c >= '0' && c <= '9'; }

enum class TokenKind : std::uint8_t {
  name,
  number,
  dot,
  plus,
  minus,
  bang,
  ampersand,
  open,
  close,
  comma,
  equals,
  origin,
  hash,
  less,
  greater,
  semicolon,
  newline,
  end,
  bad,
};

struct Token {
  TokenKind kind = TokenKind::end;
  std::string_view text;
  Position at;
  bool after_blank = false;
};

class DecLexer {
 public:
  DecLexer(std::string_view text, std::size_t file) : text_(text), file_(file) {}

  [[nodiscard]] Token next();
  // TEXT: the characters between the next character that is not blank and its second occurrence on the line. The token
  // is of kind name and spans the inside, or of kind bad if there is no such pair.
  [[nodiscard]] Token delimited();
  void skip_line();

 private:
  [[nodiscard]] char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  [[nodiscard]] Position position() const { return {file_, line_, at_ - line_start_ + 1}; }
  bool skip_blanks_and_comment();
  [[nodiscard]] Token take(TokenKind kind, std::size_t length, bool after_blank);

  std::string_view text_;
  std::size_t file_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::size_t line_start_ = 0;
  bool after_term_ = false;
};

}  // namespace sightline::assembler
