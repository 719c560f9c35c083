// See expression.hpp.
#include "host/live/expression.hpp"

#include <fmt/core.h>

#include <array>
#include <cctype>
#include <limits>
#include <string>

#include "host/base/number.hpp"

namespace sightline::live {

namespace {

using base::Error;

bool in_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '$' || c == '?' || c == '@';
}

// Wraps around where int64_t would overflow.
std::int64_t wrapped(std::uint64_t value) {
  return static_cast<std::int64_t>(value);
}

class Reader {
 public:
  Reader(std::string_view text, const Names& names) : text_(text), names_(names) {}

  base::Result<std::int64_t> all() {
    const std::int64_t value = binary(0);
    skip_blanks();
    if (error_.found.empty() && at_ != text_.size()) fail("an operator or the end");
    if (!error_.found.empty()) return error_;
    return value;
  }

 private:
  struct Operator {
    std::string_view sign;
    int level;
  };
  // By length: the longer first.
  static constexpr std::array<Operator, 19> operators{{{"||", 0}, {"&&", 1}, {"==", 5}, {"!=", 5}, {"<<", 7},
                                                       {">>", 7}, {"<=", 6}, {">=", 6}, {"|", 2},  {"^", 3},
                                                       {"&", 4},  {"=", 5},  {"<", 6},  {">", 6},  {"+", 8},
                                                       {"-", 8},  {"*", 9},  {"/", 9},  {"%", 9}}};
  static constexpr int highest_level = 9;
  static constexpr int deepest = 200;

  void skip_blanks() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }
  // The first error is the one that counts.
  std::int64_t fail(std::string_view expected, std::string found = {}) {
    if (!error_.found.empty()) return 0;
    if (found.empty()) {
      found = at_ < text_.size() ? fmt::format("found \"{}\"", text_.substr(at_)) : std::string("found the end");
    }
    error_.found = found;
    error_.expected = expected;
    at_ = text_.size();
    return 0;
  }

  [[nodiscard]] const Operator* operator_here() {
    skip_blanks();
    for (const Operator& each : operators)
      if (text_.substr(at_).starts_with(each.sign)) return &each;
    return nullptr;
  }

  std::int64_t binary(int level) {
    if (level > highest_level) return prefixed();
    std::int64_t left = binary(level + 1);
    while (true) {
      const Operator* const found = operator_here();
      if (found == nullptr || found->level != level) return left;
      at_ += found->sign.size();
      const std::int64_t right = binary(level + 1);
      left = applied(found->sign, left, right);
    }
  }

  std::int64_t applied(std::string_view sign, std::int64_t a, std::int64_t b) {
    const auto x = static_cast<std::uint64_t>(a);
    const auto y = static_cast<std::uint64_t>(b);
    if (sign == "||") return a != 0 || b != 0 ? 1 : 0;
    if (sign == "&&") return a != 0 && b != 0 ? 1 : 0;
    if (sign == "|") return a | b;
    if (sign == "^") return a ^ b;
    if (sign == "&") return a & b;
    if (sign == "==" || sign == "=") return a == b ? 1 : 0;
    if (sign == "!=") return a != b ? 1 : 0;
    if (sign == "<=") return a <= b ? 1 : 0;
    if (sign == ">=") return a >= b ? 1 : 0;
    if (sign == "<") return a < b ? 1 : 0;
    if (sign == ">") return a > b ? 1 : 0;
    if (sign == "<<") return b < 0 || b > 63 ? 0 : wrapped(x << b);
    if (sign == ">>") return b < 0 || b > 63 ? 0 : wrapped(x >> b);
    if (sign == "+") return wrapped(x + y);
    if (sign == "-") return wrapped(x - y);
    if (sign == "*") return wrapped(x * y);
    if (b == 0) return fail("a divisor other than 0", "found a division by 0");
    if (b == -1) return sign == "/" ? wrapped(std::uint64_t{0} - x) : 0;
    return sign == "/" ? a / b : a % b;
  }

  std::int64_t prefixed() {
    if (++depth_ > deepest) return fail(fmt::format("at most {} parentheses and signs", deepest), "found more");
    const std::int64_t value = primary();
    --depth_;
    return value;
  }
  std::int64_t primary() {
    skip_blanks();
    if (at_ == text_.size()) return fail("a number or a name");
    const char c = text_[at_];
    switch (c) {
      case '-': ++at_; return wrapped(std::uint64_t{0} - static_cast<std::uint64_t>(prefixed()));
      case '~': ++at_; return ~prefixed();
      case '!': ++at_; return prefixed() == 0 ? 1 : 0;
      case '(': return enclosed(')');
      case '[': return word_at(enclosed(']'));
      default: break;
    }
    const std::size_t begin = at_;
    while (at_ < text_.size() && in_name(text_[at_])) ++at_;
    const std::string_view word = text_.substr(begin, at_ - begin);
    if (word.empty()) return fail("a number or a name");
    if (const auto value = number(word, names_.radix)) return *value;
    if (const auto value = names_.value(word)) return *value;
    at_ = begin;
    return fail(std::isdigit(static_cast<unsigned char>(word.front())) != 0
                    ? fmt::format("a number in {}", names_.radix == 8    ? "octal"
                                                    : names_.radix == 16 ? "hexadecimal"
                                                                         : "decimal")
                    : "a register, a condition or a symbol",
                fmt::format("found \"{}\"", word));
  }
  std::int64_t enclosed(char end) {
    ++at_;
    const std::int64_t value = binary(0);
    skip_blanks();
    if (at_ == text_.size() || text_[at_] != end) return fail(fmt::format("\"{}\"", end));
    ++at_;
    return value;
  }
  std::int64_t word_at(std::int64_t address) {
    if (!error_.found.empty()) return 0;
    if (const auto word = names_.memory(address)) return *word;
    return fail("an address in memory", fmt::format("found address {}", address));
  }

  std::string_view text_;
  const Names& names_;
  std::size_t at_ = 0;
  int depth_ = 0;
  Error error_;
};

}  // namespace

std::optional<std::int64_t> number(std::string_view text, int radix) {
  if (text.empty() || std::isdigit(static_cast<unsigned char>(text.front())) == 0) return std::nullopt;
  const auto of = [](std::string_view digits, int base) -> std::optional<std::int64_t> {
    const auto value = base::unsigned_number(digits, base);
    if (!value || *value > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) return std::nullopt;
    return static_cast<std::int64_t>(*value);
  };
  if (text.ends_with('.')) return of(text.substr(0, text.size() - 1), 10);
  if (text.starts_with("0x") || text.starts_with("0X")) return of(text.substr(2), 16);
  if (text.starts_with("0o") || text.starts_with("0O")) return of(text.substr(2), 8);
  if (radix == 16 && (text.ends_with('h') || text.ends_with('H'))) text.remove_suffix(1);
  return of(text, radix);
}

base::Result<std::int64_t> evaluate(std::string_view text, const Names& names) {
  return Reader(text, names).all();
}

}  // namespace sightline::live
