// See predicates.hpp.
#include "host/scene/cells/bsp/predicates.hpp"

#include <cmath>
#include <cstddef>

namespace sightline::scene {
namespace {

using Approximate = std::array<double, 3>;

Approximate cross_of(const geometry::Vector3& a, const geometry::Vector3& b) {
  const auto product = [](std::int64_t x, std::int64_t y) {
    return static_cast<double>(x) * static_cast<double>(y);
  };
  return {product(a[1], b[2]) - product(a[2], b[1]), product(a[2], b[0]) - product(a[0], b[2]),
          product(a[0], b[1]) - product(a[1], b[0])};
}

}  // namespace

std::optional<geometry::Point3> integer_meeting(const geometry::Plane& a, const geometry::Plane& b,
                                                const geometry::Plane& c) {
  const Approximate by_a = cross_of(b.normal, c.normal);
  const Approximate by_b = cross_of(c.normal, a.normal);
  const Approximate by_c = cross_of(a.normal, b.normal);
  double all = 0;
  for (std::size_t i = 0; i < 3; ++i) all += by_a[i] * static_cast<double>(a.normal[i]);
  constexpr double limit = geometry::predicate_coordinate_limit;
  geometry::Point3 point{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double sum = by_a[i] * static_cast<double>(a.offset) + by_b[i] * static_cast<double>(b.offset) +
                       by_c[i] * static_cast<double>(c.offset);
    const double guess = std::nearbyint(sum / all);
    if (!(guess >= -limit && guess <= limit)) return std::nullopt;  // written so that NaN is rejected, too
    point[i] = static_cast<std::int32_t>(guess);
  }
  if (a.at(point) != 0 || b.at(point) != 0 || c.at(point) != 0) return std::nullopt;
  return point;
}

}  // namespace sightline::scene
