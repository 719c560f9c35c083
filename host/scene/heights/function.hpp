// Test functions of the literature on single-valued surfaces, by name. Figures use the first eight; the others are hard cases.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/scene/heights/grid.hpp"

namespace sightline::scene {

struct HeightFunction {
  std::string_view name;
  Interval domain;           // of x and of z
  std::string_view formula;  // r is the distance from (0, 0)
  std::string_view description;
  double (*value)(double x, double z);  // null: defined on the grid's indices
};

inline constexpr std::size_t figure_functions = 8;

// In the order of their table.
[[nodiscard]] std::span<const HeightFunction> height_functions();

// Empty for an unknown name.
[[nodiscard]] std::optional<HeightFunction> height_function(std::string_view name);

// "sinc, rogers, ...", for messages.
[[nodiscard]] std::string height_function_names();

// Sampled at size, which must be within smallest_grid and largest_grid. The range of a function of x and z is
// that on 65 x 65 points, so that pictures of different sizes agree; of the others their own.
[[nodiscard]] HeightGrid sample(const HeightFunction& function, GridSize size);

// The same over another domain. The function is one of x and z, not of the grid's indices (precondition).
[[nodiscard]] HeightGrid sample(const HeightFunction& function, const HeightDomain& domain, GridSize size);

// Any function of x and z, with a range as above; that of the grid if no height of the 65 x 65 is finite.
template <class Function>
[[nodiscard]] HeightGrid sample_values(Function&& value, const HeightDomain& domain, GridSize size) {
  const auto heights_at = [&](const std::vector<double>& x, const std::vector<double>& z) {
    const auto place = [](Interval within, double part) {
      return (within.low / 2 + within.high / 2) + part * (within.high / 2 - within.low / 2);
    };
    std::vector<double> heights;
    heights.reserve(x.size() * z.size());
    for (const double w : z) {
      for (const double u : x) heights.push_back(value(place(domain.x, u), place(domain.z, w)));
    }
    return heights;
  };
  HeightGrid grid{even_positions(size.points), even_positions(size.slices), {}, domain.x, domain.z, {}, {}};
  grid.heights = heights_at(grid.x, grid.z);
  const std::vector<double> standard = even_positions(65);
  const std::vector<double> standard_heights = heights_at(standard, standard);
  grid.range = finite_range(anywhere_finite(standard_heights) ? standard_heights : grid.heights);
  return grid;
}

}  // namespace sightline::scene
