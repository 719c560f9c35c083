#include "host/programs/flight/directions.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>

namespace sightline::programs::flight {

std::vector<Direction> directions_of(const algorithms::willis::Model& model) {
  std::vector<Direction> directions;
  std::map<algorithms::willis::Vector3, std::size_t> places;  // in `directions`, by normal
  for (std::uint32_t number = 0; number < model.pieces.size(); ++number) {
    algorithms::willis::Vector3 normal = model.pieces[number].plane.normal;
    const std::int64_t divisor = std::gcd(std::gcd(normal[0], normal[1]), normal[2]);
    const auto first = std::find_if(normal.begin(), normal.end(), [](std::int64_t value) { return value != 0; });
    const bool along = first == normal.end() || *first > 0;
    for (std::int64_t& value : normal) value = divisor == 0 ? 0 : value / divisor * (along ? 1 : -1);
    const auto [place, is_new] = places.try_emplace(normal, directions.size());
    if (is_new) directions.push_back({normal, {}});
    directions[place->second].pieces.push_back({number, along});
  }
  return directions;
}

}  // namespace sightline::programs::flight
