// Rounds a fraction of wide integers to 64 bits, for a point on a line that was computed exactly and is now drawn.
#pragma once

#include <cstdint>

#include "host/geometry/rational.hpp"
#include "host/geometry/wide_integer.hpp"

namespace sightline::geometry {

// The nearest multiple of 2^-60, halves rounded up. Precondition: 0 <= numerator <= denominator, which is not 0. Keeps
// the order.
template <unsigned bits>
[[nodiscard]] constexpr Rational rounded_fraction(const WideInteger<bits>& numerator, const WideInteger<bits>& denominator) {
  constexpr unsigned places = 60;
  const auto doubled = numerator.template shifted<places + 1>() + denominator;
  const auto steps = divide(doubled, denominator + denominator).quotient;
  return {static_cast<std::int64_t>(steps.template narrow<places + 1>().to_int128()), std::int64_t{1} << places};
}

}  // namespace sightline::geometry
