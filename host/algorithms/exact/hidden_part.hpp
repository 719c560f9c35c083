// The part of an edge that is hidden from one side of its image line: disjoint ascending open intervals with fractional
// ends. Intervals that touch are joined, because an isolated point is not drawn.
#pragma once

#include <cstdint>
#include <vector>

#include "host/geometry/integer.hpp"
#include "host/geometry/wide_integer.hpp"

namespace sightline::algorithms::exact {

// A parameter in [0, 1], not reduced: only the ends of visible pieces are. The parts are below 2^62 for 64-bit numbers,
// below 2^123 for 128-bit ones.
template <class Number>
struct Fraction {
  Number numerator = 0;
  Number denominator = 1;  // positive
};

[[nodiscard]] constexpr bool less(const Fraction<std::int64_t>& a, const Fraction<std::int64_t>& b) {
  return geometry::Int128{a.numerator} * b.denominator < geometry::Int128{b.numerator} * a.denominator;
}

[[nodiscard]] constexpr bool less(const Fraction<geometry::Int128>& a, const Fraction<geometry::Int128>& b) {
  using Wide = geometry::WideInteger<123>;
  return Wide(a.numerator) * Wide(b.denominator) < Wide(b.numerator) * Wide(a.denominator);
}

template <class Number>
struct HiddenInterval {
  Fraction<Number> low;
  Fraction<Number> high;
};

template <class Number>
class HiddenPart {
 public:
  using Interval = HiddenInterval<Number>;

  void clear() { intervals_.clear(); }

  // Adds (low, high). Has no effect unless low < high.
  void add(const Fraction<Number>& low, const Fraction<Number>& high) {
    if (!less(low, high)) return;
    auto first = intervals_.begin();
    while (first != intervals_.end() && less(first->high, low)) ++first;
    auto last = first;
    Interval joined{low, high};
    for (; last != intervals_.end() && !less(high, last->low); ++last) {
      if (less(last->low, joined.low)) joined.low = last->low;
      if (less(joined.high, last->high)) joined.high = last->high;
    }
    if (first == last) {
      intervals_.insert(first, joined);
    } else {
      *first = joined;
      intervals_.erase(first + 1, last);
    }
  }

  [[nodiscard]] bool whole() const {
    return intervals_.size() == 1 && intervals_[0].low.numerator == 0 &&
           intervals_[0].high.numerator == intervals_[0].high.denominator;
  }
  [[nodiscard]] const std::vector<Interval>& intervals() const { return intervals_; }

 private:
  std::vector<Interval> intervals_;
};

}  // namespace sightline::algorithms::exact
