// A function of x and y, or of x and z, typed by a person: sin(sqrt(x*x+y*y)).
//
// The syntax is that of muParser: + - * / ^, comparisons, && ||, a ? b : c, its functions (sin cos tan asin
// acos atan atan2 sinh cosh tanh asinh acosh atanh log2 log10 log ln exp sqrt sign rint abs min max sum avg)
// and the constants pi and e. The second variable is called y or z, not both. An assignment is refused, since it would silently
// be taken for the comparison ==.
#pragma once

#include <string>
#include <string_view>

#include "host/base/result.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::scene {

inline constexpr std::size_t longest_expression = 1024;
inline constexpr Interval expression_domain{-10, 10};  // unless told otherwise, of both

// Sampled as the functions by name are. `source` is named in errors: an error of the expression points at its
// place; an expression that is nowhere finite on the grid is an error too. The grid's names are those of the variables.
[[nodiscard]] base::Result<HeightGrid> sample_expression(const std::string& expression, const HeightDomain& domain,
                                                         GridSize size,
                                                         std::string_view source = "--function");

// "A:B" with finite A < B.
[[nodiscard]] base::Result<Interval> read_domain(const std::string& text,
                                                 std::string_view source = "--domain");

// Within smallest_grid and largest_grid, or why not.
[[nodiscard]] base::Result<GridSize> check_size(GridSize size, std::string_view source);

}  // namespace sightline::scene
