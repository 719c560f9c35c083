// A set of closed intervals with rational ends on a line: the rest when open intervals are subtracted.
//
// Laws: intervals ascend, do not touch, and have a positive length; an isolated point is dropped, because a point draws
// nothing. Sets with the same points are therefore equal by ==. Operations are idempotent; operations of one kind
// commute; intersect(low, high) subtracts everything below low and above high.
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

  // Subtracts the open interval (low, high). Has no effect if it is empty.
  void subtract(const Rational& low, const Rational& high);
  // Keeps the part in [low, high], which is empty if low >= high.
  void intersect(const Rational& low, const Rational& high);
  // Adds [low, high]. Has no effect if low >= high.
  void unite(const Rational& low, const Rational& high);

  [[nodiscard]] const std::vector<Interval>& intervals() const { return intervals_; }
  [[nodiscard]] bool empty() const { return intervals_.empty(); }
  [[nodiscard]] bool contains(const Rational& point) const;

  friend bool operator==(const IntervalSet&, const IntervalSet&) = default;

 private:
  std::vector<Interval> intervals_;
};

}  // namespace sightline::geometry
