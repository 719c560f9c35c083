#include "host/scene/heights/grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "host/base/number.hpp"
#include "host/base/result.hpp"

namespace sightline::scene {

std::vector<double> even_positions(std::size_t count) {
  std::vector<double> positions(count, 0.0);
  if (count < 2) return positions;
  const double intervals = static_cast<double>(count - 1);
  for (std::size_t i = 0; i < count; ++i) {
    positions[i] = (2.0 * static_cast<double>(i) - intervals) / intervals;
  }
  return positions;
}

std::vector<double> normalised(std::vector<double> places, Interval domain) {
  // Halves, since a difference may be beyond the greatest double.
  const double middle = domain.low / 2 + domain.high / 2;
  const double half = domain.high / 2 - domain.low / 2;
  for (double& place : places) place = std::clamp((place - middle) / half, -1.0, 1.0);
  return places;
}

std::optional<std::vector<double>> positions_of(const std::vector<double>& ascending) {
  const Interval domain{ascending.front(), ascending.back()};
  if (!(domain.high / 2 - domain.low / 2 >= std::numeric_limits<double>::min())) return std::nullopt;
  std::vector<double> positions = normalised(ascending, domain);
  if (std::adjacent_find(positions.begin(), positions.end()) != positions.end()) return std::nullopt;
  return positions;
}

base::Result<HeightGrid> even_grid(HeightDomain domain, GridSize size, std::vector<double> heights, RowOrder order,
                                   std::string_view source) {
  for (const Interval& each : {domain.x, domain.z}) {
    const double half = each.high / 2 - each.low / 2;
    if (std::isfinite(half) && half >= std::numeric_limits<double>::min()) continue;
    return base::Error{std::string(source), "", "places from " + shortest_text(each.low) + " to " + shortest_text(each.high),
                       "places that rise, of finite numbers"};
  }
  if (order == RowOrder::north_first) {
    const auto row = [&](std::size_t slice) { return heights.begin() + static_cast<std::ptrdiff_t>(slice * size.points); };
    for (std::size_t slice = 0; slice < size.slices / 2; ++slice)
      std::swap_ranges(row(slice), row(slice + 1), row(size.slices - 1 - slice));
  }
  return HeightGrid{even_positions(size.points), even_positions(size.slices), std::move(heights), domain.x, domain.z, {}, {}, {}};
}

HeightGrid thinned(const HeightGrid& grid, std::size_t step) {
  const auto step_of = [step](std::size_t count) { return std::clamp<std::size_t>(step, 1, std::max<std::size_t>(count - 1, 1)); };
  const auto reduced = [](const std::vector<double>& places, std::size_t each, Interval& domain) {
    std::vector<double> left;
    for (std::size_t i = 0; i < places.size(); i += each) left.push_back(places[i]);
    const double last = left.back();
    const double part = last / 2 + 0.5;
    if (last < 1) domain.high = domain.low * (1 - part) + domain.high * part;
    return normalised(std::move(left), {-1, last});
  };
  HeightGrid result = grid;
  const std::size_t step_x = step_of(grid.points());
  const std::size_t step_z = step_of(grid.slices());
  result.x = reduced(grid.x, step_x, result.domain_x);
  result.z = reduced(grid.z, step_z, result.domain_z);
  result.heights.clear();
  for (std::size_t slice = 0; slice < grid.slices(); slice += step_z)
    for (std::size_t point = 0; point < grid.points(); point += step_x) result.heights.push_back(grid.height(point, slice));
  return result;
}

std::string shortest_text(double number) { return base::shortest_number(number); }

Interval finite_range(const std::vector<double>& values) {
  Interval range;
  bool none = true;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    range = none ? Interval{value, value} : Interval{std::min(range.low, value), std::max(range.high, value)};
    none = false;
  }
  return range;
}

bool anywhere_finite(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double h) { return std::isfinite(h); });
}

}  // namespace sightline::scene
