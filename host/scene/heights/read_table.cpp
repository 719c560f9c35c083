#include "host/scene/heights/read_table.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "host/base/result.hpp"

namespace sightline::scene {
namespace {

bool strictly_monotone(const std::vector<double>& values) {
  const auto step = [falling = values.size() > 1 && values[0] > values[1]](double a, double b) { return !(falling ? b < a : b > a); };
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }) &&
         std::adjacent_find(values.begin(), values.end(), step) == values.end();
}

// Three or more at equal distances.
bool are_even(const std::vector<double>& values) {
  if (values.size() < 3) return false;
  const double step = (values.back() - values.front()) / static_cast<double>(values.size() - 1);
  const auto uneven = [step](double a, double b) { return !(std::abs(b - a - step) <= std::abs(step) * 1e-6); };
  return std::adjacent_find(values.begin(), values.end(), uneven) == values.end();
}

std::vector<double> places_across(const HeightLine& first) {
  std::vector<double> places;
  for (std::size_t i = 1; i < first.fields.size(); ++i) places.push_back(first.fields[i].value);
  return places;
}

std::vector<double> places_down(std::span<const HeightLine> lines) {
  std::vector<double> places;
  for (const HeightLine& line : lines) places.push_back(line.fields.front().value);
  return places;
}

}  // namespace

bool has_places(const HeightLine& first, std::span<const HeightLine> others) {
  const std::vector<double> x = places_across(first);
  const std::vector<double> y = places_down(others);
  return x.size() >= smallest_grid.points && y.size() >= smallest_grid.slices && strictly_monotone(x) && strictly_monotone(y);
}

bool is_table(const HeightLine& first, std::span<const HeightLine> others) {
  if (!has_places(first, others)) return false;
  const std::vector<double> x = places_across(first);
  const std::vector<double> y = places_down(others);
  const double corner = first.fields.front().value;
  if (std::isnan(corner) || corner == static_cast<double>(x.size())) return true;
  const auto with_corner = [corner](std::vector<double> places) {
    places.insert(places.begin(), corner);
    return places;
  };
  return are_even(x) && are_even(y) && !(are_even(with_corner(x)) && are_even(with_corner(y)));
}

base::Result<HeightGrid> read_table(const HeightLine& first, std::span<const HeightLine> others, std::string_view source) {
  if (auto error = unequal_lines(first, others, source)) return *error;
  std::vector<double> x = places_across(first);
  std::vector<double> z = places_down(others);
  if (x.size() < smallest_grid.points || z.size() < smallest_grid.slices) {
    return base::Error{std::string(source), "", count_of(z.size(), "line") + " of " + count_of(x.size(), "height"), "at least two of two"};
  }
  const auto unordered = [source](const HeightLine& line, std::size_t field, const std::string& which) {
    return base::Error{std::string(source), place_of(line.number, line.fields[field].column), which + " of places that do not rise or fall",
                       "places that rise or fall from one to the next"};
  };
  if (!strictly_monotone(x)) return unordered(first, 1, "a first line");
  if (!strictly_monotone(z)) return unordered(others.front(), 0, "a first column");
  const bool x_falls = x.front() > x.back();
  const bool z_falls = z.front() > z.back();
  if (x_falls) std::reverse(x.begin(), x.end());
  if (z_falls) std::reverse(z.begin(), z.end());
  const auto positions_x = positions_of(x);
  const auto positions_z = positions_of(z);
  if (!positions_x || !positions_z)
    return base::Error{std::string(source), "", "places that are too close to each other", "places that are farther apart"};
  HeightGrid grid{*positions_x, *positions_z, {}, {x.front(), x.back()}, {z.front(), z.back()}, {}, {}, {}};
  for (std::size_t slice = 0; slice < z.size(); ++slice) {
    const HeightLine& line = others[z_falls ? z.size() - 1 - slice : slice];
    for (std::size_t point = 0; point < x.size(); ++point)
      grid.heights.push_back(line.fields[1 + (x_falls ? x.size() - 1 - point : point)].value);
  }
  return grid;
}

}  // namespace sightline::scene
