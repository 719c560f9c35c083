#include "host/scene/heights/grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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
