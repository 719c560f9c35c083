// The lexer of 8080 source: statements of a line, the head of a statement, the tokens of its operands.
//
// Upper and lower case are the same outside quotes. `$` inside names and numbers is ignored (CP/M ASM) unless the dialect
// makes it significant. A line number before a statement is ignored. A quote is doubled inside a string of its own kind. `;`
// begins a comment.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "tools/asm/assembly.hpp"
#include "tools/asm/i8080/dialect.hpp"

namespace sightline::assembler {

// A name without its `$`, in lower case.
[[nodiscard]] inline std::string folded(std::string_view name) { return Naming{.dollar_counts = false}.key(name); }
// The key of a name: in lower case, with `$` if the dialect counts it.
[[nodiscard]] inline std::string key_of(std::string_view name, const I8080Rules& rules) {
  return Naming{.dollar_counts = rules.dollar_in_names}.key(name);
}
[[nodiscard]] bool begins_name(char c);
[[nodiscard]] bool continues_name(char c);
[[nodiscard]] bool is_blank(char c);
// Where the name at `at` ends; `at` if there is none.
[[nodiscard]] std::size_t end_of_name(std::string_view text, std::size_t at);
// The same where a name may begin with `$`.
[[nodiscard]] std::size_t end_of_name(std::string_view text, std::size_t at, const I8080Rules& rules);
[[nodiscard]] std::size_t skip_blanks(std::string_view text, std::size_t at);
// The offset after the closing quote of the string that opens at `at`, or npos if it is not closed.
[[nodiscard]] std::size_t end_of_string(std::string_view text, std::size_t at);
// A token in quotes, shortened for a message.
[[nodiscard]] std::string quoted(std::string_view text);

// Where the statement at `from` ends: at a `!` that separates statements in the dialect, outside strings and angle brackets,
// or at the end of the line. `unclosed` collects the quotes and brackets that this line leaves open; empty at its beginning.
[[nodiscard]] std::size_t end_of_statement(std::string_view line, std::size_t from, std::string& unclosed,
                                           const I8080Rules& rules);
// Where the comment begins, or the length of the text.
[[nodiscard]] std::size_t start_of_comment(std::string_view text, std::size_t from);

enum class I8080TokenKind : std::uint8_t { end, name, number, string, sign, bad };

struct I8080Token {
  I8080TokenKind kind = I8080TokenKind::end;
  std::size_t column = 0;  // offset in the statement
  std::string_view text;   // as written
  std::string value;       // name: folded; string: without quotes; bad: what was expected
  std::uint32_t number = 0;  // 0 to FFFF
  bool wrapped = false;      // the number was larger and has been reduced modulo 65536
  bool external = false;     // of a name: followed by `##`

  [[nodiscard]] bool is(char sign) const { return kind == I8080TokenKind::sign && text.size() == 1 && text[0] == sign; }
  [[nodiscard]] bool is_sign(std::string_view sign) const { return kind == I8080TokenKind::sign && text == sign; }
  [[nodiscard]] bool is_name(std::string_view name) const {
    return kind == I8080TokenKind::name && value == name;
  }
};

class I8080Lexer {
 public:
  I8080Lexer() = default;
  // Numbers without a suffix are in `radix`. The rules must outlive the lexer.
  I8080Lexer(std::string_view text, std::size_t at, const I8080Rules& rules = rules_of(I8080Dialect::common), unsigned radix = 10)
      : text_(text), at_(at), rules_(&rules), radix_(radix) {}
  I8080Token next();

 private:
  I8080Token name(std::size_t start);
  I8080Token number(std::size_t start, std::size_t digits, unsigned radix);
  I8080Token string(std::size_t start);
  I8080Token dollar(std::size_t start);

  std::string_view text_;
  std::size_t at_ = 0;
  const I8080Rules* rules_ = &rules_of(I8080Dialect::common);
  unsigned radix_ = 10;
};

}  // namespace sightline::assembler
