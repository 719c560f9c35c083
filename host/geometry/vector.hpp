// Vectors of doubles, for measuring and drawing. Decisions are made with the integers of predicates.hpp.
//
// Sums are taken from the first component to the last, and unit divides each component once, so results are bit-identical
// everywhere.
#pragma once

#include <array>
#include <cmath>

namespace sightline::geometry {

using RealVector = std::array<double, 3>;

template <class Integer>
[[nodiscard]] constexpr RealVector real_vector(const std::array<Integer, 3>& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

// From b to a.
[[nodiscard]] constexpr RealVector difference(const RealVector& a, const RealVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

[[nodiscard]] constexpr double dot(const RealVector& a, const RealVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

[[nodiscard]] constexpr RealVector cross(const RealVector& a, const RealVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

[[nodiscard]] inline double length(const RealVector& v) { return std::sqrt(dot(v, v)); }

// The vector of the same direction and length 1; a vector of length 0 is returned unchanged.
[[nodiscard]] inline RealVector unit(const RealVector& v) {
  const double size = length(v);
  return size > 0 ? RealVector{v[0] / size, v[1] / size, v[2] / size} : v;
}

}  // namespace sightline::geometry
