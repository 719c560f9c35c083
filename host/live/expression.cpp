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

constexpr int highest_level = 9;  // of a binary operator
constexpr int deepest = 200;      // nested parentheses and signs
// At each depth at most one operand of each level is on the stack, plus one at the end.
constexpr std::size_t most_operands = std::size_t{deepest + 1} * (highest_level + 1) + 1;

bool in_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '$' || c == '?' || c == '@';
}

struct BinaryOperator {
  std::string_view text;
  int level;
  Sign sign;
};
// Longer operators first.
constexpr std::array<BinaryOperator, 19> binary_operators{{
    {"||", 0, Sign::either},     {"&&", 1, Sign::both},        {"==", 5, Sign::equal},   {"!=", 5, Sign::unequal},
    {"<<", 7, Sign::shift_left}, {">>", 7, Sign::shift_right}, {"<=", 6, Sign::at_most}, {">=", 6, Sign::at_least},
    {"|", 2, Sign::bit_or},      {"^", 3, Sign::bit_xor},      {"&", 4, Sign::bit_and},  {"=", 5, Sign::equal},
    {"<", 6, Sign::less},        {">", 6, Sign::more},         {"+", 8, Sign::plus},     {"-", 8, Sign::minus},
    {"*", 9, Sign::times},       {"/", 9, Sign::divide},       {"%", 9, Sign::remainder}}};

// Applies the operator to `a`; false: a division by 0.
bool apply(Sign sign, std::int64_t& a, std::int64_t b) {
  const auto x = static_cast<std::uint64_t>(a);
  const auto y = static_cast<std::uint64_t>(b);
  const auto is = [&a](bool truth) { return a = truth ? 1 : 0, true; };
  const auto is_wrapped = [&a](std::uint64_t value) { return a = static_cast<std::int64_t>(value), true; };
  switch (sign) {
    case Sign::either: return is(a != 0 || b != 0);
    case Sign::both: return is(a != 0 && b != 0);
    case Sign::bit_or: return is_wrapped(x | y);
    case Sign::bit_xor: return is_wrapped(x ^ y);
    case Sign::bit_and: return is_wrapped(x & y);
    case Sign::equal: return is(a == b);
    case Sign::unequal: return is(a != b);
    case Sign::at_most: return is(a <= b);
    case Sign::at_least: return is(a >= b);
    case Sign::less: return is(a < b);
    case Sign::more: return is(a > b);
    case Sign::shift_left: return is_wrapped(b < 0 || b > 63 ? 0 : x << y);
    case Sign::shift_right: return is_wrapped(b < 0 || b > 63 ? 0 : x >> y);
    case Sign::plus: return is_wrapped(x + y);
    case Sign::minus: return is_wrapped(x - y);
    case Sign::times: return is_wrapped(x * y);
    case Sign::divide:
    case Sign::remainder: break;
  }
  if (b == 0) return false;
  if (b == -1) return is_wrapped(sign == Sign::divide ? std::uint64_t{0} - x : 0);
  a = sign == Sign::divide ? a / b : a % b;
  return true;
}

bool is_comparison(Sign sign) {
  return sign == Sign::equal || sign == Sign::unequal || sign == Sign::less || sign == Sign::at_most || sign == Sign::more || sign == Sign::at_least;
}

}  // namespace

// A recursive-descent parser that produces steps for a stack machine.
class ExpressionReader {
 public:
  ExpressionReader(std::string_view text, const Names& names) : text_(text), names_(names) {
    made_.names_ = &names;
  }

  base::Result<Expression> all() {
    binary(0);
    skip_blanks();
    if (error_.found.empty() && at_ != text_.size()) fail("an operator or the end");
    if (!error_.found.empty()) return error_;
    return std::move(made_);
  }

 private:
  using Kind = Expression::Step::Kind;

  void skip_blanks() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }
  // Only the first error is kept.
  void fail(std::string_view expected, std::string found = {}) {
    if (!error_.found.empty()) return;
    if (found.empty()) {
      found = at_ < text_.size() ? fmt::format("found \"{}\"", text_.substr(at_)) : std::string("found the end");
    }
    error_.found = found;
    error_.expected = expected;
    at_ = text_.size();
  }
  void add(Kind kind, std::int64_t number = 0, Sign sign = Sign::either) { made_.steps_.push_back({kind, sign, number}); }

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
      return add(Kind::name, static_cast<std::int64_t>(made_.readers_.size()) - 1);
    }
    if (const auto value = names_.value(word)) return add(Kind::number, *value);
    at_ = begin;
    fail(std::isdigit(static_cast<unsigned char>(word.front())) != 0
             ? fmt::format("a number in {}", names_.radix == 8    ? "octal"
                                             : names_.radix == 16 ? "hexadecimal"
                                                                  : "decimal")
             : names_.radix == 16 && word.find_first_not_of("0123456789abcdefABCDEF") == std::string_view::npos
                 ? "a register, a condition or a symbol; a number begins with a digit, 0" + std::string(word)
                 : "a register, a condition or a symbol; show conditions and show symbols list them",
         fmt::format("found \"{}\"", word));
  }
  void enclosed(char end) {
    ++at_;
    binary(0);
    skip_blanks();
    if (at_ == text_.size() || text_[at_] != end) return fail(fmt::format("\"{}\"", end));
    ++at_;
  }
  void word() {
    enclosed(']');
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

Expression::Outcome Expression::calculate() const {
  using End = Outcome::End;
  std::array<std::int64_t, most_operands> operands;  // NOLINT(cppcoreguidelines-pro-type-member-init): written before it is read
  std::int64_t* end = operands.data();
  for (const Step& step : steps_) {
    switch (step.kind) {
      case Step::Kind::number: *end++ = step.number; break;
      case Step::Kind::name: *end++ = readers_[static_cast<std::size_t>(step.number)](); break;
      case Step::Kind::word: {
        const auto word = names_->memory(end[-1]);
        if (!word) return {End::no_word, end[-1]};
        end[-1] = *word;
        break;
      }
      case Step::Kind::negative: end[-1] = static_cast<std::int64_t>(std::uint64_t{0} - static_cast<std::uint64_t>(end[-1])); break;
      case Step::Kind::complement: end[-1] = ~end[-1]; break;
      case Step::Kind::no: end[-1] = end[-1] == 0 ? 1 : 0; break;
      case Step::Kind::binary:
        --end;
        if (!apply(step.sign, end[-1], *end)) return {End::division_by_0};
        break;
    }
  }
  return {End::value, operands.front()};
}

base::Result<std::int64_t> Expression::value() const {
  const Outcome calculated = this->calculate();
  switch (calculated.end) {
    case Outcome::End::value: break;
    case Outcome::End::no_word:
      return base::Error{.found = fmt::format("found address {}", calculated.number), .expected = "an address in memory"};
    case Outcome::End::division_by_0: return base::Error{.found = "found a division by 0", .expected = "a divisor other than 0"};
  }
  return calculated.number;
}

bool Expression::holds() const {
  const Outcome calculated = this->calculate();
  return calculated.end != Outcome::End::value || calculated.number != 0;
}

std::optional<std::vector<std::int64_t>> Expression::change_points() const {
  using Kind = Step::Kind;
  std::vector<std::int64_t> points;
  std::vector<Step> stack;  // numbers and names; `no` stands for a truth value
  // A name alone is true if it is not 0.
  const auto take_truth = [&] {
    if (stack.back().kind == Kind::name) points.insert(points.end(), {0, 1});
    stack.pop_back();
  };
  for (const Step& step : steps_) {
    if (step.kind == Kind::number || step.kind == Kind::name) {
      stack.push_back(step);
      continue;
    }
    if (step.kind == Kind::no) {
      take_truth();
    } else if (step.kind == Kind::binary && (step.sign == Sign::both || step.sign == Sign::either)) {
      take_truth();
      take_truth();
    } else if (step.kind == Kind::binary && is_comparison(step.sign)) {
      const Step right = stack.back(), left = stack[stack.size() - 2];
      const bool by_number = left.kind == Kind::name && right.kind == Kind::number;
      if (!by_number && !(left.kind == Kind::number && right.kind == Kind::name)) return std::nullopt;
      const std::int64_t number = by_number ? right.number : left.number;
      points.push_back(number);
      if (number != std::numeric_limits<std::int64_t>::max()) points.push_back(number + 1);
      stack.resize(stack.size() - 2);
    } else {
      return std::nullopt;
    }
    stack.push_back({Kind::no});
  }
  take_truth();
  return points;
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
