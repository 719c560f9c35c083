// A function of x and y, or of x and z, that a person types: sin(sqrt(x*x+y*y)).
//
//   operators   from weak to strong: a ? b : c, ||, &&, comparisons (< <= > >= == !=), + -, * /, sign, ^ (from right to left)
//   functions   sin cos tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh exp ln log (the same as ln) log2 log10 sqrt abs
//               sign rint (halves upwards), and of any number of values min max sum avg
//   constants   pi and e
//
// A condition holds if its value is not 0; comparisons, && and || have the value 0 or 1. The second variable is called y or z, not
// both. An assignment is an error, because people write = and mean ==.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::scene {

inline constexpr std::size_t longest_expression = 1024;
inline constexpr std::size_t deepest_expression = 100;  // parentheses, signs, powers and choices within each other
inline constexpr Interval expression_domain{-10, 10};   // of both variables, if no other is given

// An expression as a program for a stack of numbers.
class Expression {
 public:
  // Of any number of values.
  using Operation = double (*)(const double* values, std::size_t count);

  // The error names the column in `text`. `source` is named in it.
  [[nodiscard]] static base::Result<Expression> parse(const std::string& text, std::string_view source = "--function");

  [[nodiscard]] double operator()(double x, double second) const;
  // The name of the second variable; 'z' if the expression does not have it.
  [[nodiscard]] char second() const { return second_; }

 private:
  friend class ExpressionParser;
  struct Step {
    enum class Kind : std::uint8_t { number, x, second, operation } kind = Kind::number;
    std::size_t count = 0;  // of the values that the operation takes from the stack
    double number = 0;
    Operation operation = nullptr;
  };

  std::vector<Step> steps_;
  char second_ = 'z';
};

// Sampled as the functions by name are. `source` is named in errors. An expression that is nowhere finite on the grid is an
// error, too. The grid's names are those of the variables.
[[nodiscard]] base::Result<HeightGrid> sample_expression(const std::string& expression, const HeightDomain& domain, GridSize size,
                                                         std::string_view source = "--function");

// "A:B" with finite A < B.
[[nodiscard]] base::Result<Interval> read_domain(const std::string& text, std::string_view source = "--domain");

// Within smallest_grid and largest_grid, or why not.
[[nodiscard]] base::Result<GridSize> check_size(GridSize size, std::string_view source);

}  // namespace sightline::scene
