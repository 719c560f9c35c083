// Vectors in doubles.
#pragma once

#include <array>
#include <cmath>

#include "host/geometry/predicates.hpp"

namespace sightline::algorithms::plantinga {

using Near3 = std::array<double, 3>;

inline Near3 near_of(const geometry::Vector3& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}
inline Near3 difference(const Near3& a, const Near3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline double dot(const Near3& a, const Near3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Near3 cross(const Near3& a, const Near3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length_of(const Near3& v) { return std::sqrt(dot(v, v)); }

}  // namespace sightline::algorithms::plantinga
