// Stretches of edges: an interval of s with fractional ends, clipped plane by plane.
#pragma once

#include <cstdint>

#include "host/geometry/integer.hpp"
#include "host/geometry/wide_integer.hpp"

namespace sightline::algorithms::jones {

// A parameter in [0, 1], not reduced. Its parts are below 2^63 for 64-bit numbers and 2^127 for 128-bit ones: each is a
// value of a plane at a vertex, below 2^62 or 2^126 (visible_edges.cpp), or the difference of two.
template <class Number>
struct Fraction {
  Number numerator = 0;
  Number denominator = 1;  // positive
};

[[nodiscard]] inline bool less(const Fraction<std::int64_t>& a, const Fraction<std::int64_t>& b) {
  return geometry::Int128{a.numerator} * b.denominator < geometry::Int128{b.numerator} * a.denominator;
}

[[nodiscard]] inline bool less(const Fraction<geometry::Int128>& a, const Fraction<geometry::Int128>& b) {
  using Part = geometry::WideInteger<127>;
  return Part(a.numerator) * Part(b.denominator) < Part(b.numerator) * Part(a.denominator);
}

// A quantity changes linearly from a to b. hides(): it is nowhere positive and somewhere negative. cuts(): it is
// somewhere negative. Both avoid branches, because the signs are unpredictable and a misprediction costs more than the
// arithmetic. Precondition: |a| and |b| are below the greatest number.
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

  // Keeps the part where a quantity that changes linearly from a (s = 0) to b (s = 1) is not negative. Returns false if
  // certainly nothing is left; otherwise the rest may still be empty or a point (low not less than high).
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
