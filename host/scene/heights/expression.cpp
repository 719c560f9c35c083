#include "host/scene/heights/expression.hpp"

#include <muParser.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <optional>

#include "host/base/number.hpp"
#include "host/base/result.hpp"
#include "host/scene/heights/function.hpp"

namespace sightline::scene {
namespace {

base::Error error_at(const std::string& expression, std::string_view source, std::size_t place,
                     std::string found, std::string expected) {
  place = std::min(place, expression.size());
  base::Error error{std::string(source), std::to_string(place + 1), std::move(found), std::move(expected)};
  error.excerpt = "  " + expression + "\n  " + std::string(place, ' ') + "^";
  return error;
}

// The first '=' that is not part of a comparison.
std::optional<std::size_t> assignment(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '=') continue;
    if (i + 1 < text.size() && text[i + 1] == '=') {
      ++i;
      continue;
    }
    if (i == 0 || std::string_view("<>!").find(text[i - 1]) == std::string_view::npos) return i;
  }
  return std::nullopt;
}

std::optional<base::Error> refused(const std::string& expression, std::string_view source) {
  if (expression.size() > longest_expression) {
    return base::Error{std::string(source), "",
                       "an expression of " + std::to_string(expression.size()) + " characters",
                       "at most " + std::to_string(longest_expression)};
  }
  const auto strange =
      std::find_if(expression.begin(), expression.end(), [](char c) { return c < ' ' || c > '~'; });
  if (strange != expression.end()) {
    return base::Error{std::string(source), std::to_string(strange - expression.begin() + 1),
                       "a character that is not printable ASCII", "an expression of x and y, or of x and z"};
  }
  if (const auto place = assignment(expression))
    return error_at(expression, source, *place, "an assignment", "a comparison is written ==");
  return std::nullopt;
}

// The first ',' outside all parentheses; the end if there is none.
std::size_t outer_comma(const std::string& text) {
  int depth = 0;
  std::size_t at = 0;
  for (; at < text.size() && (text[at] != ',' || depth != 0); ++at) {
    if (text[at] == '(') ++depth;
    if (text[at] == ')') --depth;
  }
  return at;
}

// What the parser says without where: that is said in our own way, and counted from 1.
std::string without_position(std::string message) {
  for (const std::string_view where :
       {" found at position ", " at expression position ", " at position ", " (position: "})
    message.resize(std::min(message.rfind(where), message.size()));
  while (!message.empty() && (message.back() == '.' || message.back() == ' ')) message.pop_back();
  return message;
}

// Where a variable of one letter is first named.
std::size_t variable(const std::string& text, char name) {
  const auto part_of_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.'; };
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == name && (i == 0 || !part_of_word(text[i - 1])) && (i + 1 == text.size() || !part_of_word(text[i + 1]))) return i;
  }
  return 0;
}

class Evaluator {
 public:
  explicit Evaluator(const std::string& expression) {
    parser_.ClearConst();
    parser_.DefineConst("pi", std::numbers::pi);
    parser_.DefineConst("e", std::numbers::e);
    parser_.DefineVar("x", &x_);
    parser_.DefineVar("y", &z_);
    parser_.DefineVar("z", &z_);
    parser_.SetExpr(expression);
    static_cast<void>(parser_.Eval());
    if (parser_.GetNumResults() != 1)
      throw mu::ParserError(mu::ecUNEXPECTED_ARG_SEP, ",", expression,
                            static_cast<int>(outer_comma(expression)));
    const auto& used = parser_.GetUsedVar();
    uses_y_ = used.count("y") != 0;
    if (uses_y_ && used.count("z") != 0) throw mu::ParserError(mu::ecUNASSIGNABLE_TOKEN, "z", expression, static_cast<int>(variable(expression, 'z')));
  }
  Evaluator(const Evaluator&) = delete;
  Evaluator& operator=(const Evaluator&) = delete;

  double operator()(double x, double z) {
    x_ = x;
    z_ = z;
    return parser_.Eval();
  }
  // Rather than z.
  [[nodiscard]] bool uses_y() const { return uses_y_; }

 private:
  bool uses_y_ = false;
  double x_ = 0;
  double z_ = 0;
  mu::Parser parser_;
};

}  // namespace

base::Result<HeightGrid> sample_expression(const std::string& expression, const HeightDomain& domain, GridSize size,
                                           std::string_view source) {
  const auto checked = check_size(size, source);
  if (!checked) return checked.error();
  if (auto error = refused(expression, source)) return *error;
  try {
    Evaluator value(expression);
    HeightGrid grid = sample_values(value, domain, size);
    grid.names = {"x", value.uses_y() ? "y" : "z", ""};
    if (anywhere_finite(grid.heights)) return grid;
    return error_at(expression, source, 0, "a function that is nowhere finite on its domain",
                    "a number at some place");
  } catch (const mu::ParserError& error) {
    const int place = error.GetPos();
    if (error.GetCode() == mu::ecUNASSIGNABLE_TOKEN && error.GetToken() == "z")
      return error_at(expression, source, static_cast<std::size_t>(std::max(place, 0)), "z beside y", "one name for the second variable");
    return error_at(expression, source, place < 0 ? expression.size() : static_cast<std::size_t>(place),
                    "an error: " + without_position(error.GetMsg()), "an expression of x and y, or of x and z");
  }
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
