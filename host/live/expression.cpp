// See expression.hpp.
#include "host/live/expression.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <string>
#include <utility>

#include "host/base/number.hpp"

namespace sightline::live {

namespace {

bool in_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '$' || c == '?' || c == '@';
}

// Wraps around where int64_t would overflow.
std::int64_t wrapped(std::uint64_t value) {
  return static_cast<std::int64_t>(value);
}

enum Sign : std::uint8_t { either, both, equal, unequal, shift_left, shift_right, at_most, at_least, bit_or, bit_xor, bit_and, same, less, more, plus, minus, times, divide, remainder };

struct BinaryOperator {
  std::string_view text;
  int level;
  Sign sign;
};
// By length: the longer first.
constexpr std::array<BinaryOperator, 19> binary_operators{{{"||", 0, either},  {"&&", 1, both},     {"==", 5, equal},     {"!=", 5, unequal},
                                              {"<<", 7, shift_left}, {">>", 7, shift_right}, {"<=", 6, at_most}, {">=", 6, at_least},
                                              {"|", 2, bit_or},   {"^", 3, bit_xor},   {"&", 4, bit_and},    {"=", 5, same},
                                              {"<", 6, less},     {">", 6, more},      {"+", 8, plus},       {"-", 8, minus},
                                              {"*", 9, times},    {"/", 9, divide},    {"%", 9, remainder}}};

// Nothing: a division by 0.
std::optional<std::int64_t> applied(Sign sign, std::int64_t a, std::int64_t b) {
  const auto x = static_cast<std::uint64_t>(a);
  const auto y = static_cast<std::uint64_t>(b);
  switch (sign) {
    case either: return a != 0 || b != 0 ? 1 : 0;
    case both: return a != 0 && b != 0 ? 1 : 0;
    case bit_or: return a | b;
    case bit_xor: return a ^ b;
    case bit_and: return a & b;
    case equal:
    case same: return a == b ? 1 : 0;
    case unequal: return a != b ? 1 : 0;
    case at_most: return a <= b ? 1 : 0;
    case at_least: return a >= b ? 1 : 0;
    case less: return a < b ? 1 : 0;
    case more: return a > b ? 1 : 0;
    case shift_left: return b < 0 || b > 63 ? 0 : wrapped(x << b);
    case shift_right: return b < 0 || b > 63 ? 0 : wrapped(x >> b);
    case plus: return wrapped(x + y);
    case minus: return wrapped(x - y);
    case times: return wrapped(x * y);
    case divide:
    case remainder: break;
  }
  if (b == 0) return std::nullopt;
  if (b == -1) return sign == divide ? wrapped(std::uint64_t{0} - x) : 0;
  return sign == divide ? a / b : a % b;
}

}  // namespace

// By recursive descent, to steps for a stack.
class ExpressionReader {
 public:
  ExpressionReader(std::string_view text, const Names& names) : text_(text), names_(names) {
    made_.names_ = &names;
    made_.places_.emplace();
  }

  base::Result<Expression> all() {
    binary(0);
    skip_blanks();
    if (error_.found.empty() && at_ != text_.size()) fail("an operator or the end");
    if (!error_.found.empty()) return error_;
    return std::move(made_);
  }

 private:
  using Kind = Expression::Kind;
  static constexpr int highest_level = 9;
  static constexpr int deepest = 200;

  void skip_blanks() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }
  // The first error is the one that counts.
  void fail(std::string_view expected, std::string found = {}) {
    if (!error_.found.empty()) return;
    if (found.empty()) {
      found = at_ < text_.size() ? fmt::format("found \"{}\"", text_.substr(at_)) : std::string("found the end");
    }
    error_.found = found;
    error_.expected = expected;
    at_ = text_.size();
  }
  void add(Kind kind, std::int64_t number = 0, std::uint8_t sign = 0) { made_.steps_.push_back({kind, sign, number}); }
  void nothing_is_fixed() { made_.places_.reset(); }

  [[nodiscard]] const BinaryOperator* operator_here() {
    skip_blanks();
    for (const BinaryOperator& each : binary_operators)
      if (text_.substr(at_).starts_with(each.text)) return &each;
    return nullptr;
  }

  void binary(int level) {
    if (level > highest_level) return prefixed();
    binary(level + 1);
    while (true) {
      const BinaryOperator* const found = operator_here();
      if (found == nullptr || found->level != level) return;
      at_ += found->text.size();
      binary(level + 1);
      add(Kind::binary, 0, found->sign);
    }
  }

  void prefixed() {
    if (++depth_ > deepest) return fail(fmt::format("at most {} parentheses and signs", deepest), "found more");
    primary();
    --depth_;
  }
  void signed_by(Kind kind) {
    ++at_;
    prefixed();
    add(kind);
  }
  void primary() {
    skip_blanks();
    if (at_ == text_.size()) return fail("a number or a name");
    switch (text_[at_]) {
      case '-': return signed_by(Kind::negative);
      case '~': return signed_by(Kind::complement);
      case '!': return signed_by(Kind::no);
      case '(': return enclosed(')');
      case '[': return word();
      default: break;
    }
    const std::size_t begin = at_;
    while (at_ < text_.size() && in_name(text_[at_])) ++at_;
    const std::string_view word = text_.substr(begin, at_ - begin);
    if (word.empty()) return fail("a number or a name");
    if (const auto value = number(word, names_.radix)) return add(Kind::number, *value);
    if (auto reader = names_.reader ? names_.reader(word) : nullptr) {
      made_.readers_.push_back(std::move(reader));
      made_.read_names_.emplace_back(word);
      nothing_is_fixed();
      return add(Kind::name, static_cast<std::int64_t>(made_.readers_.size()) - 1);
    }
    if (const auto value = names_.value(word)) return add(Kind::number, *value);
    at_ = begin;
    fail(std::isdigit(static_cast<unsigned char>(word.front())) != 0
             ? fmt::format("a number in {}", names_.radix == 8    ? "octal"
                                             : names_.radix == 16 ? "hexadecimal"
                                                                  : "decimal")
             : "a register, a condition or a symbol",
         fmt::format("found \"{}\"", word));
  }
  void enclosed(char end) {
    ++at_;
    binary(0);
    skip_blanks();
    if (at_ == text_.size() || text_[at_] != end) return fail(fmt::format("\"{}\"", end));
    ++at_;
  }
  // Its address is fixed if nothing in it changes.
  void word() {
    const std::size_t first = made_.steps_.size();
    enclosed(']');
    if (!error_.found.empty()) return;
    Expression address;
    address.names_ = &names_;
    address.steps_.assign(made_.steps_.begin() + static_cast<std::ptrdiff_t>(first), made_.steps_.end());
    const bool changes = std::any_of(address.steps_.begin(), address.steps_.end(), [](const Expression::Step& step) {
      return step.kind == Kind::name || step.kind == Kind::word;
    });
    const auto at = changes ? base::Result<std::int64_t>(base::fail("")) : address.value();
    if (!at) nothing_is_fixed();
    if (at && made_.places_) made_.places_->push_back(*at);
    add(Kind::word);
  }

  std::string_view text_;
  const Names& names_;
  std::size_t at_ = 0;
  int depth_ = 0;
  base::Error error_;
  Expression made_;
};

base::Result<Expression> Expression::read(std::string_view text, const Names& names) {
  return ExpressionReader(text, names).all();
}

base::Result<std::int64_t> Expression::value() const {
  constexpr std::size_t usual = 64;
  std::array<std::int64_t, usual> small;
  std::vector<std::int64_t> large;
  if (steps_.size() > usual) large.resize(steps_.size());
  std::int64_t* const stack = large.empty() ? small.data() : large.data();
  std::size_t top = 0;
  for (const Step& step : steps_) {
    switch (step.kind) {
      case Kind::number: stack[top++] = step.number; break;
      case Kind::name: stack[top++] = readers_[static_cast<std::size_t>(step.number)](); break;
      case Kind::word: {
        const auto word = names_->memory(stack[top - 1]);
        if (!word) return base::Error{.found = fmt::format("found address {}", stack[top - 1]), .expected = "an address in memory"};
        stack[top - 1] = *word;
        break;
      }
      case Kind::negative: stack[top - 1] = wrapped(std::uint64_t{0} - static_cast<std::uint64_t>(stack[top - 1])); break;
      case Kind::complement: stack[top - 1] = ~stack[top - 1]; break;
      case Kind::no: stack[top - 1] = stack[top - 1] == 0 ? 1 : 0; break;
      case Kind::binary: {
        const auto result = applied(static_cast<Sign>(step.sign), stack[top - 2], stack[top - 1]);
        if (!result) return base::Error{.found = "found a division by 0", .expected = "a divisor other than 0"};
        stack[--top - 1] = *result;
        break;
      }
    }
  }
  return stack[0];
}

namespace {

using Range = Expression::Range;
constexpr std::uint32_t all_ones = ~std::uint32_t{0};

// What is known of a part of an expression: a constant, a name with a mask, or where it can be true.
struct Known {
  std::optional<std::int64_t> constant;
  std::optional<Range> name;  // its mask alone counts
  std::optional<Range> truth;
};

// Of NAME sign CONSTANT.
std::optional<Range> compared(Range name, Sign sign, std::int64_t constant) {
  if (constant < 0 || constant > std::int64_t{all_ones} - 1) return std::nullopt;
  const auto c = static_cast<std::uint32_t>(constant);
  switch (sign) {
    case equal:
    case same: name.first = c; name.span = 0; break;
    case unequal: name.first = c + 1; name.span = all_ones - 1; break;
    case less:
      if (c == 0) return std::nullopt;
      name.first = 0; name.span = c - 1; break;
    case at_most: name.first = 0; name.span = c; break;
    case more: name.first = c + 1; name.span = all_ones - name.first; break;
    case at_least: name.first = c; name.span = all_ones - c; break;
    default: return std::nullopt;
  }
  return name;
}

Sign turned(Sign sign) {
  switch (sign) {
    case less: return more;
    case more: return less;
    case at_most: return at_least;
    case at_least: return at_most;
    default: return sign;
  }
}

// A name, or bits of it, is true when not 0.
std::optional<Range> truth_of(const Known& known) {
  return known.truth ? known.truth : known.name ? compared(*known.name, unequal, 0) : std::nullopt;
}

Known combined(const Known& a, Sign sign, const Known& b) {
  Known made;
  if (sign == both) {
    const auto left = truth_of(a), right = truth_of(b);
    made.truth = !left || (right && right->span < left->span) ? right : left;
  } else if (sign == bit_and && (a.name ? b.constant : a.constant) && (a.name || b.name)) {
    made.name = a.name ? a.name : b.name;
    made.name->mask &= static_cast<std::uint32_t>(a.name ? *b.constant : *a.constant);
  } else if (a.name && b.constant) {
    made.truth = compared(*a.name, sign, *b.constant);
  } else if (a.constant && b.name) {
    made.truth = compared(*b.name, turned(sign), *a.constant);
  } else if (a.constant && b.constant) {
    made.constant = applied(sign, *a.constant, *b.constant);
  }
  return made;
}

}  // namespace

bool Expression::has_words() const {
  return std::any_of(steps_.begin(), steps_.end(), [](const Step& step) { return step.kind == Kind::word; });
}

std::optional<Range> Expression::range() const {
  std::vector<Known> stack;
  for (const Step& step : steps_) {
    Known made;
    if (step.kind == Kind::number) made.constant = step.number;
    if (step.kind == Kind::name) made.name = Range{.name = static_cast<std::size_t>(step.number)};
    if (step.kind == Kind::binary) {
      const Known right = stack.back();
      stack.pop_back();
      made = combined(stack.back(), static_cast<Sign>(step.sign), right);
      stack.pop_back();
    } else if (step.kind != Kind::number && step.kind != Kind::name) {
      if (step.kind == Kind::no && stack.back().name) made.truth = compared(*stack.back().name, equal, 0);
      stack.pop_back();
    }
    stack.push_back(made);
  }
  return truth_of(stack.back());
}

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
  const auto expression = Expression::read(text, names);
  if (!expression) return expression.error();
  return expression->value();
}

}  // namespace sightline::live
