// Stretches of edges: an interval of s with fractional ends, cut down plane by plane.
#pragma once

#include <cstdint>

#include "host/algorithms/jones/fixed_integer.hpp"
#include "host/geometry/integer.hpp"

namespace sightline::algorithms::jones {

// In [0, 1], not in lowest terms. Parts below 2^62 for 64 bits, 2^126 for 128.
template <class Number>
struct Fraction {
  Number numerator = 0;
  Number denominator = 1;  // positive
};

[[nodiscard]] inline bool less(const Fraction<std::int64_t>& a, const Fraction<std::int64_t>& b) {
  return geometry::Int128{a.numerator} * b.denominator < geometry::Int128{b.numerator} * a.denominator;
}

[[nodiscard]] inline bool less(const Fraction<geometry::Int128>& a, const Fraction<geometry::Int128>& b) {
  using Product = FixedInteger<4>;
  return (Product(a.numerator) * Product(b.denominator) - Product(b.numerator) * Product(a.denominator))
             .sign() < 0;
}

// A quantity goes linearly from a to b: nowhere positive, and somewhere negative (hides); somewhere negative
// (cuts). Bit by bit, without a branch: of lines in masks the signs are not to be foreseen, and guessing them
// wrong costs more than the arithmetic. |a|, |b| below the greatest number.
template <class Number>
[[nodiscard]] bool hides(const Number& a, const Number& b) {
  return ((a - 1) & (b - 1) & (a | b)) < 0;
}
template <class Number>
[[nodiscard]] bool cuts(const Number& a, const Number& b) {
  return (a | b) < 0;
}

template <class Number>
struct Stretch {
  Fraction<Number> low;
  Fraction<Number> high;

  // Keeps where a quantity that goes linearly from a (s = 0) to b (s = 1) is not negative. False if nothing
  // is left for certain; what is left may also be empty or a point, low not less than high.
  bool keep_not_negative(const Number& a, const Number& b) {
    if (a < 0) {
      if (b <= 0) return false;
      const Fraction<Number> enters{-a, b - a};
      if (less(low, enters)) low = enters;
    } else if (b < 0) {
      if (a == 0) return false;
      const Fraction<Number> leaves{a, a - b};
      if (less(leaves, high)) high = leaves;
    }
    return true;
  }
};

}  // namespace sightline::algorithms::jones
