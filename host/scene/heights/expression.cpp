#include "host/scene/heights/expression.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include "host/base/number.hpp"
#include "host/base/result.hpp"
#include "host/scene/heights/function.hpp"

namespace sightline::scene {
namespace {

using Operation = Expression::Operation;

// A double as C++ has it: NaN is a condition that holds.
constexpr bool holds(double value) { return value != 0; }

// Products, so that small whole powers are the same on every machine; libraries round pow differently.
double power(const double* v, std::size_t /*count*/) {
  if (v[1] == 2) return v[0] * v[0];
  if (v[1] == 3) return v[0] * v[0] * v[0];
  if (v[1] == 4) return v[0] * v[0] * v[0] * v[0];
  return std::pow(v[0], v[1]);
}
double sum(const double* v, std::size_t count) {
  double total = 0;
  for (std::size_t i = 0; i < count; ++i) total += v[i];
  return total;
}
// The least or the greatest value; not a number if a value is none.
template <class Before>
double best(const double* v, std::size_t count, Before before) {
  double result = v[0];
  for (std::size_t i = 1; i < count; ++i)
    if (std::isnan(v[i]) || before(v[i], result)) result = v[i];
  return result;
}
double sign_of(const double* v, std::size_t /*count*/) { return v[0] < 0 ? -1 : v[0] > 0 ? 1 : v[0] == 0 ? 0 : v[0]; }
double negated(const double* v, std::size_t /*count*/) { return -v[0]; }
double chosen(const double* v, std::size_t /*count*/) { return holds(v[0]) ? v[1] : v[2]; }

struct BinaryOperator {
  std::string_view text;
  int strength;
  Operation operation;
};
// Of two that begin alike the longer one comes first.
constexpr std::array<BinaryOperator, 12> binary_operators{{
    {"||", 1, [](const double* v, std::size_t) { return holds(v[0]) || holds(v[1]) ? 1.0 : 0.0; }},
    {"&&", 2, [](const double* v, std::size_t) { return holds(v[0]) && holds(v[1]) ? 1.0 : 0.0; }},
    {"<=", 3, [](const double* v, std::size_t) { return v[0] <= v[1] ? 1.0 : 0.0; }},
    {">=", 3, [](const double* v, std::size_t) { return v[0] >= v[1] ? 1.0 : 0.0; }},
    {"==", 3, [](const double* v, std::size_t) { return v[0] == v[1] ? 1.0 : 0.0; }},
    {"!=", 3, [](const double* v, std::size_t) { return v[0] != v[1] ? 1.0 : 0.0; }},
    {"<", 3, [](const double* v, std::size_t) { return v[0] < v[1] ? 1.0 : 0.0; }},
    {">", 3, [](const double* v, std::size_t) { return v[0] > v[1] ? 1.0 : 0.0; }},
    {"+", 4, [](const double* v, std::size_t) { return v[0] + v[1]; }},
    {"-", 4, [](const double* v, std::size_t) { return v[0] - v[1]; }},
    {"*", 5, [](const double* v, std::size_t) { return v[0] * v[1]; }},
    {"/", 5, [](const double* v, std::size_t) { return v[0] / v[1]; }},
}};

struct NamedFunction {
  std::string_view name;
  std::size_t count;  // of its values; 0: one or more
  Operation operation;
};
constexpr std::array<NamedFunction, 26> named_functions{{
    {"sin", 1, [](const double* v, std::size_t) { return std::sin(v[0]); }},
    {"cos", 1, [](const double* v, std::size_t) { return std::cos(v[0]); }},
    {"tan", 1, [](const double* v, std::size_t) { return std::tan(v[0]); }},
    {"asin", 1, [](const double* v, std::size_t) { return std::asin(v[0]); }},
    {"acos", 1, [](const double* v, std::size_t) { return std::acos(v[0]); }},
    {"atan", 1, [](const double* v, std::size_t) { return std::atan(v[0]); }},
    {"atan2", 2, [](const double* v, std::size_t) { return std::atan2(v[0], v[1]); }},
    {"sinh", 1, [](const double* v, std::size_t) { return std::sinh(v[0]); }},
    {"cosh", 1, [](const double* v, std::size_t) { return std::cosh(v[0]); }},
    {"tanh", 1, [](const double* v, std::size_t) { return std::tanh(v[0]); }},
    {"asinh", 1, [](const double* v, std::size_t) { return std::asinh(v[0]); }},
    {"acosh", 1, [](const double* v, std::size_t) { return std::acosh(v[0]); }},
    {"atanh", 1, [](const double* v, std::size_t) { return std::atanh(v[0]); }},
    {"exp", 1, [](const double* v, std::size_t) { return std::exp(v[0]); }},
    {"ln", 1, [](const double* v, std::size_t) { return std::log(v[0]); }},
    {"log", 1, [](const double* v, std::size_t) { return std::log(v[0]); }},
    {"log2", 1, [](const double* v, std::size_t) { return std::log2(v[0]); }},
    {"log10", 1, [](const double* v, std::size_t) { return std::log10(v[0]); }},
    {"sqrt", 1, [](const double* v, std::size_t) { return std::sqrt(v[0]); }},
    {"abs", 1, [](const double* v, std::size_t) { return std::abs(v[0]); }},
    {"sign", 1, sign_of},
    {"rint", 1, [](const double* v, std::size_t) { return std::floor(v[0] + 0.5); }},
    {"min", 0, [](const double* v, std::size_t count) { return best(v, count, std::less<>()); }},
    {"max", 0, [](const double* v, std::size_t count) { return best(v, count, std::greater<>()); }},
    {"sum", 0, sum},
    {"avg", 0, [](const double* v, std::size_t count) { return sum(v, count) / static_cast<double>(count); }},
}};

std::string names_of_functions() {
  std::string names;
  for (const NamedFunction& function : named_functions) names += (names.empty() ? "" : " ") + std::string(function.name);
  return names;
}

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

// Digits with at most one point, and an exponent if it has digits; its length, 0 if there are no digits.
std::size_t length_of_number(std::string_view text) {
  const auto digits = [text](std::size_t at) {
    while (at < text.size() && is_digit(text[at])) ++at;
    return at;
  };
  const std::size_t whole = digits(0);
  std::size_t end = whole;
  if (end < text.size() && text[end] == '.') end = digits(end + 1);
  if (whole == 0 && end < 2) return 0;
  if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
    const std::size_t sign = end + 1 < text.size() && (text[end + 1] == '+' || text[end + 1] == '-') ? 1 : 0;
    const std::size_t exponent = digits(end + 1 + sign);
    if (exponent > end + 1 + sign) end = exponent;
  }
  return end;
}

}  // namespace

// Writes the steps of an operation behind those of its values. The first error ends it: all functions return at once.
class ExpressionParser {
 public:
  ExpressionParser(const std::string& text, std::string_view source) : text_(text), source_(source) {}

  base::Result<Expression> parse() {
    if (text_.size() > longest_expression) {
      return base::Error{std::string(source_), "", "an expression of " + std::to_string(text_.size()) + " characters",
                         "at most " + std::to_string(longest_expression)};
    }
    const auto strange = std::find_if(text_.begin(), text_.end(), [](char c) { return c < ' ' || c > '~'; });
    if (strange != text_.end()) {
      return base::Error{std::string(source_), std::to_string(strange - text_.begin() + 1),
                         "a character that is not printable ASCII", "an expression of x and y, or of x and z"};
    }
    read_choice();
    if (!error_ && skip_blanks() < text_.size()) fail_here("an operator or the end");
    if (error_) return *error_;
    return std::move(expression_);
  }

 private:
  using Kind = Expression::Step::Kind;

  std::size_t skip_blanks() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    return at_;
  }
  bool take(std::string_view token) {
    if (text_.compare(skip_blanks(), token.size(), token) != 0) return false;
    at_ += token.size();
    return true;
  }
  void fail(std::size_t place, std::string found, std::string expected) {
    if (error_) return;
    error_ = base::Error{std::string(source_), std::to_string(place + 1), std::move(found), std::move(expected)};
    error_->excerpt = "  " + text_ + "\n  " + std::string(place, ' ') + "^";
  }
  void fail_here(const std::string& expected) {
    const std::size_t place = skip_blanks();
    if (place == text_.size()) return fail(place, "the end of the expression", expected);
    // Also of +=, -=, *= and /=, at the sign of equality.
    const std::size_t equal = std::string_view("+-*/^").find(text_[place]) != std::string_view::npos ? place + 1 : place;
    if (equal < text_.size() && text_[equal] == '=') return fail(equal, "an assignment", "== for a comparison");
    fail(place, std::string("'") + text_[place] + "'", expected);
  }

  void push(double number) { expression_.steps_.push_back({Kind::number, 0, number, nullptr}); }
  void apply(Operation operation, std::size_t count) { expression_.steps_.push_back({Kind::operation, count, 0, operation}); }

  template <class Read>
  void deeper(const Read& read) {
    if (depth_ == deepest_expression)
      return fail(at_, "an expression within more than " + std::to_string(deepest_expression) + " others", "a flatter one");
    ++depth_;
    read();
    --depth_;
  }

  void read_choice() {
    deeper([this] {
      read_operators(1);
      if (error_ || !take("?")) return;
      read_choice();
      if (error_) return;
      if (!take(":")) return fail_here("':' and the value if the condition does not hold");
      read_choice();
      apply(chosen, 3);
    });
  }
  // Of operators of at least this strength, from left to right.
  void read_operators(int weakest) {
    read_signed();
    while (!error_) {
      const BinaryOperator* found = nullptr;
      skip_blanks();
      for (const BinaryOperator& each : binary_operators)
        if (found == nullptr && text_.compare(at_, each.text.size(), each.text) == 0) found = &each;
      if (found == nullptr || found->strength < weakest) return;
      at_ += found->text.size();
      read_operators(found->strength + 1);
      apply(found->operation, 2);
    }
  }
  // At most one sign before a value and its powers: -x^2 is -(x^2).
  void read_signed() {
    if (take("-")) {
      read_power();
      apply(negated, 1);
    } else {
      static_cast<void>(take("+"));
      read_power();
    }
  }
  void read_power() {
    read_value();
    if (error_ || !take("^")) return;
    deeper([this] { read_signed(); });
    apply(power, 2);
  }
  void read_value() {
    if (take("(")) {
      read_choice();
      if (!error_ && !take(")")) fail_here("an operator or ')'");
      return;
    }
    const std::string_view rest = std::string_view(text_).substr(at_);
    if (const std::size_t length = length_of_number(rest); length > 0) {
      at_ += length;
      const auto number = base::decimal_number(rest.substr(0, length));
      if (!number) return fail(at_ - length, "a number beyond the largest double", "a number up to 1.7e308");
      return push(*number);
    }
    std::size_t length = 0;
    while (length < rest.size() && (is_letter(rest[length]) || (length > 0 && is_digit(rest[length])))) ++length;
    if (length == 0) return fail_here("a number, x, y, z, pi, e, a function or '('");
    read_name(rest.substr(0, length));
  }
  void read_name(std::string_view name) {
    const std::size_t place = at_;
    at_ += name.size();
    if (name == "x") return expression_.steps_.push_back({Kind::x, 0, 0, nullptr});
    if (name == "y" || name == "z") {
      if (has_second_ && expression_.second_ != name.front()) {
        return fail(place, std::string(name) + " beside " + expression_.second_, "one name for the second variable");
      }
      has_second_ = true;
      expression_.second_ = name.front();
      return expression_.steps_.push_back({Kind::second, 0, 0, nullptr});
    }
    if (name == "pi") return push(std::numbers::pi);
    if (name == "e") return push(std::numbers::e);
    const auto function = std::find_if(named_functions.begin(), named_functions.end(),
                                       [name](const NamedFunction& each) { return each.name == name; });
    if (function == named_functions.end()) {
      return fail(place, "the unknown name " + std::string(name), "x, y or z, pi, e or a function: " + names_of_functions());
    }
    if (!take("(")) return fail_here("'(' and the values of " + std::string(name));
    std::size_t count = 0;
    do {
      read_choice();
      ++count;
    } while (!error_ && take(","));
    if (error_) return;
    if (!take(")")) return fail_here("an operator, ',' or ')'");
    if (function->count != 0 && count != function->count) {
      return fail(place, std::string(name) + " of " + std::to_string(count) + (count == 1 ? " value" : " values"),
                  std::to_string(function->count) + (function->count == 1 ? " value" : " values"));
    }
    apply(function->operation, count);
  }

  const std::string& text_;
  std::string_view source_;
  std::size_t at_ = 0;
  std::size_t depth_ = 0;
  bool has_second_ = false;
  Expression expression_;
  std::optional<base::Error> error_;
};

base::Result<Expression> Expression::parse(const std::string& text, std::string_view source) {
  return ExpressionParser(text, source).parse();
}

double Expression::operator()(double x, double second) const {
  // Every value is at least one character of the text.
  std::array<double, longest_expression> stack;  // NOLINT(cppcoreguidelines-pro-type-member-init): written before it is read
  std::size_t top = 0;
  for (const Step& step : steps_) {
    switch (step.kind) {
      case Step::Kind::number: stack[top++] = step.number; break;
      case Step::Kind::x: stack[top++] = x; break;
      case Step::Kind::second: stack[top++] = second; break;
      case Step::Kind::operation:
        top -= step.count;
        stack[top] = step.operation(&stack[top], step.count);
        ++top;
        break;
    }
  }
  return stack[0];
}

base::Result<HeightGrid> sample_expression(const std::string& expression, const HeightDomain& domain, GridSize size,
                                           std::string_view source) {
  const auto checked = check_size(size, source);
  if (!checked) return checked.error();
  const auto value = Expression::parse(expression, source);
  if (!value) return value.error();
  HeightGrid grid = sample_values(*value, domain, size);
  grid.names = {"x", std::string(1, value->second()), ""};
  if (anywhere_finite(grid.heights)) return grid;
  return base::Error{std::string(source),      "1", "a function that is nowhere finite on its domain",
                     "a number at some place", "",  "  " + expression + "\n  ^"};
}

base::Result<Interval> read_domain(const std::string& text, std::string_view source) {
  const base::Error error{std::string(source), "", "'" + text + "'", "A:B with numbers A < B, such as -3:3"};
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) return error;
  const auto low = base::decimal_number(std::string_view(text).substr(0, colon));
  const auto high = base::decimal_number(std::string_view(text).substr(colon + 1));
  if (!low || !high || !(*low < *high)) return error;
  return Interval{*low, *high};
}

base::Result<GridSize> check_size(GridSize size, std::string_view source) {
  const auto inside = [](std::size_t n, std::size_t low, std::size_t high) { return n >= low && n <= high; };
  if (inside(size.points, smallest_grid.points, largest_grid.points) &&
      inside(size.slices, smallest_grid.slices, largest_grid.slices)) {
    return size;
  }
  return base::Error{std::string(source), "",
                     std::to_string(size.slices) + " slices of " + std::to_string(size.points) + " points",
                     "2 to 1024 slices of 2 to 1024 points"};
}

}  // namespace sightline::scene
