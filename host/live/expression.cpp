// See expression.hpp.
#include "host/live/expression.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <span>
#include <string>
#include <utility>

#include "host/base/number.hpp"

namespace sightline::live {

using guests::run::applied;
using guests::run::Sign;
using guests::run::ConditionStep;

namespace {

bool in_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '$' || c == '?' || c == '@';
}

struct BinaryOperator {
  std::string_view text;
  int level;
  Sign sign;
};
// By length: the longer first.
constexpr std::array<BinaryOperator, 19> binary_operators{{
    {"||", 0, Sign::either},     {"&&", 1, Sign::both},        {"==", 5, Sign::equal},   {"!=", 5, Sign::unequal},
    {"<<", 7, Sign::shift_left}, {">>", 7, Sign::shift_right}, {"<=", 6, Sign::at_most}, {">=", 6, Sign::at_least},
    {"|", 2, Sign::bit_or},      {"^", 3, Sign::bit_xor},      {"&", 4, Sign::bit_and},  {"=", 5, Sign::equal},
    {"<", 6, Sign::less},        {">", 6, Sign::more},         {"+", 8, Sign::plus},     {"-", 8, Sign::minus},
    {"*", 9, Sign::times},       {"/", 9, Sign::divide},       {"%", 9, Sign::remainder}}};

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
  using Kind = ConditionStep::Kind;
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
  void add(Kind kind, std::int64_t number = 0, Sign sign = Sign::either) { made_.steps_.push_back({kind, sign, number}); }
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
  // Its address is fixed if nothing in it changes.
  void word() {
    const std::size_t first = made_.steps_.size();
    enclosed(']');
    if (!error_.found.empty()) return;
    Expression address;
    address.names_ = &names_;
    address.steps_.assign(made_.steps_.begin() + static_cast<std::ptrdiff_t>(first), made_.steps_.end());
    const bool changes = std::any_of(address.steps_.begin(), address.steps_.end(), [](const ConditionStep& step) {
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
  struct Values {
    const Expression& of;
    std::optional<std::int64_t>& missing;
    [[nodiscard]] std::int64_t name(std::size_t n) const { return of.readers_[n](); }
    static std::int64_t register_value(std::size_t) { return 0; }
    static std::int64_t register_pair(std::size_t) { return 0; }
    static std::int64_t time() { return 0; }
    [[nodiscard]] std::optional<std::int64_t> word(std::int64_t address) const {
      const auto word = of.names_->memory(address);
      if (!word) missing = address;
      return word;
    }
  };
  std::optional<std::int64_t> missing;  // address
  if (const auto value = guests::run::value_of(steps_, Values{*this, missing})) return *value;
  if (missing) return base::Error{.found = fmt::format("found address {}", *missing), .expected = "an address in memory"};
  return base::Error{.found = "found a division by 0", .expected = "a divisor other than 0"};
}

namespace {

using Range = Expression::Range;
using NamesRelation = Expression::Relation;

// What is known of a part of an expression: a constant; a name with a mask, less another one, and an offset; where it can be true.
struct Known {
  std::optional<std::int64_t> constant;
  std::optional<Range> name;  // its mask alone counts
  std::optional<Range> less;  // likewise
  std::int64_t offset = 0;
  std::optional<Range> truth;
  std::optional<NamesRelation> relation = {};

  [[nodiscard]] bool plain_name() const { return name && !less && offset == 0; }
};

bool is_comparison(Sign sign) {
  return sign == Sign::equal || sign == Sign::unequal || sign == Sign::less || sign == Sign::at_most || sign == Sign::more || sign == Sign::at_least;
}

// Of DIFFERENCE sign 0.
Known compared(const Known& difference, Sign sign) {
  Known made;
  if (!difference.name) return made;
  if (difference.less) {
    made.relation = NamesRelation{*difference.name, sign, *difference.less, -difference.offset};
  } else if (const auto range = guests::run::range_where(sign, -difference.offset)) {
    made.truth = difference.name;
    made.truth->first = range->first;
    made.truth->span = range->span;
    made.truth->exact = true;
  }
  return made;
}

// A name, or bits of it, is true when not 0.
std::optional<Range> truth_of(const Known& known) {
  return known.truth || !known.plain_name() ? known.truth : compared(known, Sign::unequal).truth;
}

// Nothing is known where there would be two names to add, or a number that is no offset of a register.
Known difference(const Known& a, const Known& b) {
  constexpr std::int64_t most = std::int64_t{1} << 40;
  Known made;
  if (a.constant.value_or(0) > most || a.constant.value_or(0) < -most || b.constant.value_or(0) > most || b.constant.value_or(0) < -most) return made;
  const bool right_is_constant = b.constant && !b.name, left_is_constant = a.constant && !a.name;
  if (a.name && right_is_constant) {
    made.name = a.name;
    made.less = a.less;
    made.offset = a.offset - *b.constant;
  } else if (a.name && b.name && !a.less && !b.less) {
    made.name = a.name;
    made.less = b.name;
    made.offset = a.offset - b.offset;
  } else if (left_is_constant && b.name && b.less) {
    made.name = b.less;
    made.less = b.name;
    made.offset = *a.constant - b.offset;
  }
  if (made.offset > most || made.offset < -most) return {};
  return made;
}

Known combined(const Known& a, Sign sign, const Known& b) {
  Known made;
  if (sign == Sign::both) {
    const auto left = truth_of(a), right = truth_of(b);
    made.truth = !left || (right && right->span < left->span) ? right : left;
    if (made.truth) made.truth->exact = false;
  } else if (a.constant && b.constant) {
    made.constant = applied(sign, *a.constant, *b.constant);
  } else if (sign == Sign::bit_and && ((a.plain_name() && b.constant) || (a.constant && b.plain_name()))) {
    made.name = a.name ? a.name : b.name;
    made.name->mask &= static_cast<std::uint32_t>(a.name ? *b.constant : *a.constant);
  } else if (sign == Sign::minus) {
    made = difference(a, b);
  } else if (sign == Sign::plus && (a.constant || b.constant)) {
    Known constant;
    constant.constant = applied(Sign::minus, 0, a.constant ? *a.constant : *b.constant);
    made = difference(a.constant ? b : a, constant);
  } else if (is_comparison(sign)) {
    made = a.constant ? compared(difference(b, a), guests::run::turned(sign)) : compared(difference(a, b), sign);
  }
  return made;
}

// Of the whole.
Known known_of(std::span<const ConditionStep> steps) {
  using Kind = ConditionStep::Kind;
  std::vector<Known> stack;
  for (const ConditionStep& step : steps) {
    Known made;
    if (step.kind == Kind::number) made.constant = step.number;
    if (step.kind == Kind::name) made.name = Range{.name = static_cast<std::size_t>(step.number)};
    if (step.kind == Kind::binary) {
      const Known right = stack.back();
      stack.pop_back();
      made = combined(stack.back(), step.sign, right);
      stack.pop_back();
    } else if (step.kind != Kind::number && step.kind != Kind::name) {
      if (step.kind == Kind::no && stack.back().plain_name()) made = compared(stack.back(), Sign::equal);
      stack.pop_back();
    }
    stack.push_back(made);
  }
  return stack.back();
}

}  // namespace

bool Expression::has_words() const {
  return std::any_of(steps_.begin(), steps_.end(), [](const ConditionStep& step) { return step.kind == ConditionStep::Kind::word; });
}

std::optional<Range> Expression::range() const {
  return truth_of(known_of(steps_));
}

std::optional<NamesRelation> Expression::relation() const {
  return known_of(steps_).relation;
}

std::optional<std::vector<Expression::Turn>> Expression::turns() const {
  using Kind = ConditionStep::Kind;
  struct Part {
    Kind kind = Kind::no;  // number, name, or no: a truth
    std::int64_t number = 0;
  };
  std::vector<Turn> turns;
  std::vector<Part> stack;
  const auto turn_at = [&turns](const Part& name, std::int64_t at) { turns.push_back({static_cast<std::size_t>(name.number), at}); };
  // A name alone is true when it is not 0.
  const auto take_truth = [&] {
    if (stack.back().kind == Kind::name) {
      turn_at(stack.back(), 0);
      turn_at(stack.back(), 1);
    }
    stack.pop_back();
  };
  for (const ConditionStep& step : steps_) {
    if (step.kind == Kind::number || step.kind == Kind::name) {
      stack.push_back({step.kind, step.number});
      continue;
    }
    if (step.kind == Kind::no) {
      take_truth();
    } else if (step.kind == Kind::binary && (step.sign == Sign::both || step.sign == Sign::either)) {
      take_truth();
      take_truth();
    } else if (step.kind == Kind::binary && is_comparison(step.sign)) {
      const Part right = stack.back(), left = stack[stack.size() - 2];
      const bool by_number = left.kind == Kind::name && right.kind == Kind::number;
      if (!by_number && !(left.kind == Kind::number && right.kind == Kind::name)) return std::nullopt;
      const Part& name = by_number ? left : right;
      const std::int64_t number = by_number ? right.number : left.number;
      turn_at(name, number);
      if (number != std::numeric_limits<std::int64_t>::max()) turn_at(name, number + 1);
      stack.resize(stack.size() - 2);
    } else {
      return std::nullopt;
    }
    stack.push_back({});
  }
  take_truth();
  return turns;
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
