// An exact fraction of two 64-bit integers, in lowest terms, the denominator positive.
//
// Laws: equal values have equal parts, so == is exact; the order is total and exact (any two int64 products fit in 128
// bits); mediant(a, b) lies strictly between a < b. There is no arithmetic: a sum of two fractions may need twice the
// bits, and the predicates that use this type avoid sums. Precondition: both given parts are above -2^63, the denominator
// is not 0 (asserted).
#pragma once

#include <cassert>
#include <compare>
#include <cstdint>

#include "host/geometry/integer.hpp"

namespace sightline::geometry {

class Rational {
 public:
  constexpr Rational() = default;
  constexpr Rational(std::int64_t integer) : numerator_(integer) {}  // NOLINT: an integer is a rational
  constexpr Rational(std::int64_t numerator, std::int64_t denominator) {
    assert(denominator != 0);
    const auto common = static_cast<std::int64_t>(common_divisor(
        static_cast<std::uint64_t>(numerator < 0 ? -numerator : numerator),
        static_cast<std::uint64_t>(denominator < 0 ? -denominator : denominator)));
    const std::int64_t divisor = denominator < 0 ? -common : common;
    numerator_ = numerator / divisor;
    denominator_ = denominator / divisor;
  }

  [[nodiscard]] constexpr std::int64_t numerator() const { return numerator_; }
  [[nodiscard]] constexpr std::int64_t denominator() const { return denominator_; }
  // Exact to the last place if both parts are below 2^53.
  [[nodiscard]] constexpr double to_double() const {
    return static_cast<double>(numerator_) / static_cast<double>(denominator_);
  }

  friend constexpr bool operator==(const Rational&, const Rational&) = default;
  friend constexpr std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
    const Int128 left = Int128{a.numerator_} * b.denominator_;
    const Int128 right = Int128{b.numerator_} * a.denominator_;
    if (left < right) return std::strong_ordering::less;
    return left > right ? std::strong_ordering::greater : std::strong_ordering::equal;
  }

 private:
  std::int64_t numerator_ = 0;
  std::int64_t denominator_ = 1;
};

// A fraction strictly between a and b (a < b); its parts have at most one bit more than the longer parts of a and b.
[[nodiscard]] constexpr Rational mediant(const Rational& a, const Rational& b) {
  return {a.numerator() + b.numerator(), a.denominator() + b.denominator()};
}

}  // namespace sightline::geometry
