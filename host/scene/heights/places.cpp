#include "host/scene/heights/places.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace sightline::scene {

Places::Places(std::vector<double> values) {
  constexpr double same_place = 1e-9;
  std::sort(values.begin(), values.end());
  // Halves, since a difference may be beyond the greatest double.
  const double extent = values.back() / 2 - values.front() / 2;
  for (const double value : values)
    if (places_.empty() || value / 2 - places_.back() / 2 > same_place * extent) places_.push_back(value);
}

std::size_t Places::index(double value) const {
  return static_cast<std::size_t>(std::upper_bound(places_.begin(), places_.end(), value) - places_.begin()) - 1;
}

std::optional<std::vector<double>> positions_of(const std::vector<double>& ascending) {
  const Interval domain{ascending.front(), ascending.back()};
  if (!(domain.high / 2 - domain.low / 2 >= std::numeric_limits<double>::min())) return std::nullopt;
  std::vector<double> positions = normalised(ascending, domain);
  if (std::adjacent_find(positions.begin(), positions.end()) != positions.end()) return std::nullopt;
  return positions;
}

}  // namespace sightline::scene
