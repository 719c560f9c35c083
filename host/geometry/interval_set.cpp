#include "host/geometry/interval_set.hpp"

#include <algorithm>

namespace sightline::geometry {

IntervalSet::IntervalSet(const Rational& low, const Rational& high) {
  if (low < high) intervals_.push_back({low, high});
}

void IntervalSet::subtract(const Rational& low, const Rational& high) {
  if (!(low < high)) return;
  std::vector<Interval> left;
  left.reserve(intervals_.size() + 1);
  for (const Interval& piece : intervals_) {
    if (piece.high <= low || high <= piece.low) {
      left.push_back(piece);
      continue;
    }
    if (piece.low < low) left.push_back({piece.low, low});
    if (high < piece.high) left.push_back({high, piece.high});
  }
  intervals_ = std::move(left);
}

void IntervalSet::intersect(const Rational& low, const Rational& high) {
  std::vector<Interval> left;
  for (const Interval& piece : intervals_) {
    const Interval common{std::max(piece.low, low), std::min(piece.high, high)};
    if (common.low < common.high) left.push_back(common);
  }
  intervals_ = std::move(left);
}

void IntervalSet::unite(const Rational& low, const Rational& high) {
  if (!(low < high)) return;
  if (intervals_.empty() || intervals_.back().high < low) return intervals_.push_back({low, high});
  Interval grown{low, high};
  std::vector<Interval> all;
  all.reserve(intervals_.size() + 1);
  for (const Interval& piece : intervals_) {
    if (piece.high < grown.low || grown.high < piece.low) {
      all.push_back(piece);
    } else {
      grown = {std::min(piece.low, grown.low), std::max(piece.high, grown.high)};
    }
  }
  const auto place =
      std::find_if(all.begin(), all.end(), [&](const Interval& piece) { return grown.high < piece.low; });
  all.insert(place, grown);
  intervals_ = std::move(all);
}

bool IntervalSet::contains(const Rational& point) const {
  return std::any_of(intervals_.begin(), intervals_.end(),
                     [&](const Interval& piece) { return piece.low <= point && point <= piece.high; });
}

}  // namespace sightline::geometry
