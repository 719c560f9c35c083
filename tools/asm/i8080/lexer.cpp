#include "tools/asm/i8080/lexer.hpp"

#include <algorithm>
#include <utility>

namespace sightline::assembler {
namespace {

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return lower(c) >= 'a' && lower(c) <= 'z';
}

// 99 if `c` is a digit of no radix.
unsigned digit_value(char c) {
  if (is_digit(c)) return static_cast<unsigned>(c - '0');
  return is_letter(c) ? static_cast<unsigned>(lower(c) - 'a') + 10U : 99U;
}

unsigned radix_of_suffix(char c) {
  switch (lower(c)) {
    case 'h': return 16;
    case 'o':
    case 'q': return 8;
    case 'b': return 2;
    case 'd': return 10;
    default: return 0;
  }
}

const char* name_of_radix(unsigned radix) {
  return radix == 16 ? "hexadecimal" : radix == 8 ? "octal" : radix == 2 ? "binary" : radix == 10 ? "decimal" : "radix";
}

// The offset after the part in angle brackets that opens at `at`, or npos if it is not closed.
std::size_t end_of_brackets(std::string_view text, std::size_t at) {
  std::size_t depth = 0;
  for (std::size_t i = at; i < text.size(); ++i) {
    if (text[i] == '<') ++depth;
    if (text[i] == '>' && --depth == 0) return i + 1;
  }
  return std::string_view::npos;
}

// A quote or bracket that is not closed counts as a plain character, and so do all later ones of its kind. The search
// thus stays linear, also when it continues after a stop with the same `plain`.
std::size_t find_outside_groups(std::string_view text, std::size_t from, std::string_view stops,
                                std::string& plain) {
  for (std::size_t i = from; i < text.size();) {
    const char c = text[i];
    if (stops.find(c) != std::string_view::npos) return i;
    const bool opens = (c == '\'' || c == '"' || c == '<') && plain.find(c) == std::string::npos;
    if (!opens) {
      ++i;
      continue;
    }
    const std::size_t end = c == '<' ? end_of_brackets(text, i) : end_of_string(text, i);
    if (end == std::string_view::npos) plain += c;
    i = end == std::string_view::npos ? i + 1 : end;
  }
  return text.size();
}

}  // namespace

bool begins_name(char c) {
  return is_letter(c) || c == '?' || c == '@' || c == '.' || c == '_';
}
bool continues_name(char c) {
  return begins_name(c) || is_digit(c) || c == '$';
}
bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v' || c == '\x1A';
}

std::size_t end_of_name(std::string_view text, std::size_t at, const I8080Rules& rules) {
  if (!rules.dollar_in_names || at + 1 >= text.size() || text[at] != '$' || !continues_name(text[at + 1]))
    return end_of_name(text, at);
  while (at < text.size() && continues_name(text[at])) ++at;
  return at;
}

std::size_t end_of_name(std::string_view text, std::size_t at) {
  if (at >= text.size() || !begins_name(text[at])) return at;
  while (at < text.size() && continues_name(text[at])) ++at;
  return at;
}

std::size_t skip_blanks(std::string_view text, std::size_t at) {
  while (at < text.size() && is_blank(text[at])) ++at;
  return at;
}

std::size_t end_of_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  for (std::size_t i = at + 1; i < text.size(); ++i) {
    if (text[i] != quote) continue;
    if (i + 1 < text.size() && text[i + 1] == quote) {
      ++i;
      continue;
    }
    return i + 1;
  }
  return std::string_view::npos;
}

std::string quoted(std::string_view text) {
  std::string shown = "'";
  for (const char c : text.substr(0, 24)) shown += c >= ' ' && c < 0x7F ? c : '?';
  return shown + (text.size() > 24 ? "...'" : "'");
}

std::size_t end_of_statement(std::string_view line, std::size_t from, std::string& unclosed, const I8080Rules& rules) {
  if (!rules.bang_separates) return line.size();
  const std::size_t at = find_outside_groups(line, from, "!;", unclosed);
  if (at >= line.size() || line[at] != ';') return at;
  return rules.bang_ends_comment ? std::min(line.find('!', at), line.size()) : line.size();
}

std::size_t start_of_comment(std::string_view text, std::size_t from) {
  std::string unclosed;
  return find_outside_groups(text, from, ";", unclosed);
}

I8080Token I8080Lexer::next() {
  at_ = skip_blanks(text_, at_);
  if (at_ >= text_.size() || text_[at_] == ';') return {I8080TokenKind::end, at_, {}, {}};
  const std::size_t start = at_;
  const char c = text_[start];
  if (end_of_name(text_, start, *rules_) > start) return name(start);
  if (c == '\'' || c == '"') return string(start);
  if (c == '$') return dollar(start);
  if (!is_digit(c)) {
    const std::string_view two = text_.substr(start, 2);
    const std::size_t length = two == "<=" || two == ">=" || two == "<>" ? 2 : 1;
    at_ += length;
    return {I8080TokenKind::sign, start, text_.substr(start, length), {}};
  }
  if (c == '0' && start + 2 < text_.size() && lower(text_[start + 1]) == 'x' &&
      digit_value(text_[start + 2]) < 16)
    return number(start, start + 2, 16);
  return number(start, start, 0);
}

I8080Token I8080Lexer::name(std::size_t start) {
  at_ = end_of_name(text_, start, *rules_);
  const std::string_view text = text_.substr(start, at_ - start);
  // X'0F', a hexadecimal number of MACRO-80.
  if (lower(text.front()) == 'x' && text.size() == 1 && at_ + 2 < text_.size() && text_[at_] == '\'' &&
      digit_value(text_[at_ + 1]) < 16) {
    I8080Token token = number(start, at_ + 1, 16);
    if (at_ < text_.size() && text_[at_] == '\'') {
      ++at_;
      token.text = text_.substr(start, at_ - start);
    } else {
      token.kind = I8080TokenKind::bad;
      token.value = "hexadecimal digits between quotes";
    }
    return token;
  }
  I8080Token token{I8080TokenKind::name, start, text, key_of(text, *rules_)};
  // NAME## is an external of MACRO-80; its definition is found like that of any other name.
  if (text_.substr(at_).starts_with("##")) {
    token.external = true;
    at_ += 2;
  }
  return token;
}

// `$` before a digit begins a number, else it is the location. Before a letter it could be either or begin a name.
I8080Token I8080Lexer::dollar(std::size_t start) {
  if (start + 1 < text_.size() && is_digit(text_[start + 1])) return number(start, start + 1, 16);
  if (start + 1 < text_.size() && begins_name(text_[start + 1])) {
    at_ = end_of_name(text_, start + 1);
    return {I8080TokenKind::bad, start, text_.substr(start, at_ - start),
            "a number that begins with a digit, or `$` alone; --dialect m80 has names that begin with `$`"};
  }
  return {I8080TokenKind::sign, start, text_.substr(at_++, 1), {}};
}

// If `radix` is 0 the suffix gives it.
I8080Token I8080Lexer::number(std::size_t start, std::size_t digits, unsigned radix) {
  at_ = digits;
  while (at_ < text_.size() && (digit_value(text_[at_]) < 99 || text_[at_] == '$')) ++at_;
  I8080Token token{I8080TokenKind::number, start, text_.substr(start, at_ - start), {}};
  std::string written = folded(text_.substr(digits, at_ - digits));
  if (radix == 0) {
    radix = radix_of_suffix(written.back());
    // B and D are digits of a radix of 16.
    if (radix_ > 11 && (radix == 2 || radix == 10)) radix = 0;
    if (radix != 0) written.pop_back();
    if (radix == 0) radix = radix_;
  }
  for (const char c : written) {
    const unsigned digit = digit_value(c);
    if (digit >= radix) {
      token.kind = I8080TokenKind::bad;
      token.value = std::string(radix == 8 ? "an " : "a ") + name_of_radix(radix) + " number" +
                    (radix == 10 ? " or a suffix H O Q B" : "");
      return token;
    }
    token.number = token.number * radix + digit;
    token.wrapped = token.wrapped || token.number > 0xFFFF;
    token.number &= 0xFFFFU;
  }
  return token;
}

I8080Token I8080Lexer::string(std::size_t start) {
  const std::size_t end = end_of_string(text_, start);
  if (end == std::string_view::npos) {
    at_ = text_.size();
    return {I8080TokenKind::bad, start, text_.substr(start), "a closing quote"};
  }
  at_ = end;
  I8080Token token{I8080TokenKind::string, start, text_.substr(start, end - start), {}};
  for (std::size_t i = start + 1; i + 1 < end; ++i) {
    token.value += text_[i];
    if (text_[i] == text_[start]) ++i;
  }
  return token;
}

}  // namespace sightline::assembler
