// A set of closed intervals with rational ends on a line, as left over when open intervals are taken away.
//
// Laws: intervals are in ascending order, do not touch, and have a positive length: what is left as a single
// point is dropped, because a point draws nothing. Two sets of the same points are therefore equal by ==. An
// operation done twice is done once; operations of one kind may change places; intersect(low, high) subtracts
// what is below low and what is above high.
#pragma once

#include <vector>

#include "host/geometry/rational.hpp"

namespace sightline::geometry {

struct Interval {
  Rational low;
  Rational high;

  friend constexpr bool operator==(const Interval&, const Interval&) = default;
};

class IntervalSet {
 public:
  IntervalSet() = default;
  // [low, high]; empty unless low < high.
  IntervalSet(const Rational& low, const Rational& high);

  // Subtracts the open interval (low, high); no effect if it is empty.
  void subtract(const Rational& low, const Rational& high);
  // Keeps what lies in [low, high]; nothing is left if low >= high.
  void intersect(const Rational& low, const Rational& high);
  // Adds [low, high]; no effect if low >= high.
  void unite(const Rational& low, const Rational& high);

  [[nodiscard]] const std::vector<Interval>& intervals() const { return intervals_; }
  [[nodiscard]] bool empty() const { return intervals_.empty(); }
  [[nodiscard]] bool contains(const Rational& point) const;

  friend bool operator==(const IntervalSet&, const IntervalSet&) = default;

 private:
  std::vector<Interval> intervals_;
};

}  // namespace sightline::geometry
