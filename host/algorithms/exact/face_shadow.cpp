#include "host/algorithms/exact/face_shadow.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace sightline::algorithms::exact {
namespace {

constexpr Fraction start{0, 1};
constexpr Fraction end{1, 1};

// Where a quantity vanishes that is a at the start and b at the end, of opposite signs.
constexpr Fraction zero_between(std::int64_t a, std::int64_t b) {
  return a > 0 ? Fraction{a, a - b} : Fraction{-a, b - a};
}

constexpr geometry::Rational rational(const Fraction& f) {
  return {f.numerator, f.denominator};
}

}  // namespace

void EdgeShadow::begin(std::uint32_t edge) {
  edge_ = edge;
  const picture::LineEdge& ends = view_.mesh->edges[edge];
  a_ = view_.points[ends.from];
  b_ = view_.points[ends.to];
  plane_ = view_.planes[edge];
  split_ = false;
  left_.clear();
  if (!view_.perspective) return;
  const std::int64_t near = view_.depths[ends.from];
  const std::int64_t far = view_.depths[ends.to];
  if (near < 0) left_.add(start, zero_between(near, far));
  if (far < 0) left_.add(zero_between(near, far), end);
}

bool EdgeShadow::add(const Occluder& occluder) {
  const std::int64_t a = occluder.beyond.at(a_);
  const std::int64_t b = occluder.beyond.at(b_);
  if (a <= 0 && b <= 0) return false;
  const std::size_t count = occluder.corner_count;
  sides_.resize(count);
  std::int64_t low = 1;
  std::int64_t high = -1;
  bool touches = false;
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t side = plane_.at(view_.points[view_.mesh->corners[occluder.first_corner + i].vertex]);
    sides_[i] = side;
    low = std::min(low, side);
    high = std::max(high, side);
    touches = touches || side == 0;
  }
  if (low > 0 || high < 0) return false;
  const HiddenInterval beyond{a < 0 ? zero_between(a, b) : start, b < 0 ? zero_between(a, b) : end};
  if (touches) {
    if (high > 0) cast(occluder, beyond, 1, true, false);
    if (low < 0) cast(occluder, beyond, 0, false, true);
  } else {
    cast(occluder, beyond, 0, true, true);
  }
  return left_.whole() && (!split_ || right_.whole());
}

// `threshold`: from which value on a corner counts as to the left.
void EdgeShadow::cast(const Occluder& occluder, const HiddenInterval& beyond, std::int64_t threshold,
                      bool left, bool right) {
  const Corner* const corners = &view_.mesh->corners[occluder.first_corner];
  bool inside = false;
  changes_.clear();
  for (std::size_t i = 0; i < occluder.corner_count; ++i) {
    const bool leaves = sides_[i] >= threshold;
    const bool arrives = sides_[corners[i].next] >= threshold;
    if (leaves == arrives) continue;
    const Plane& side = view_.planes[corners[i].side];
    const bool positive = corners[i].with_edge == arrives;  // (side reversed) xor (crossed rightwards)
    std::int64_t from = side.at(a_);
    std::int64_t to = side.at(b_);
    if (!positive) {
      from = -from;
      to = -to;
    }
    if (from > 0 || (from == 0 && to > 0)) inside = !inside;
    if ((from > 0 && to < 0) || (from < 0 && to > 0)) changes_.push_back(zero_between(from, to));
  }
  std::sort(changes_.begin(), changes_.end(), less);
  Fraction low = beyond.low;
  for (const Fraction& change : changes_) {
    if (inside) hide({low, less(change, beyond.high) ? change : beyond.high}, left, right);
    inside = !inside;
    if (less(low, change)) low = change;
  }
  if (inside) hide({low, beyond.high}, left, right);
}

void EdgeShadow::hide(const HiddenInterval& interval, bool left, bool right) {
  if (left != right && !split_) {
    split_ = true;
    right_ = left_;
  }
  if (left || !split_) left_.add(interval.low, interval.high);
  if (right && split_) right_.add(interval.low, interval.high);
}

// Hidden is what both sides hide; the gaps between are seen.
void EdgeShadow::append_visible(std::vector<picture::LinePiece>& pieces) const {
  const picture::LineEdge& edge = view_.mesh->edges[edge_];
  Fraction seen_from = start;
  const auto see_up_to = [&](const Fraction& low) {
    if (less(seen_from, low)) pieces.push_back({edge, rational(seen_from), rational(low)});
  };
  const auto& right = split_ ? right_.intervals() : left_.intervals();
  auto other = right.begin();
  for (const HiddenInterval& one : left_.intervals()) {
    while (other != right.end() && !less(one.low, other->high)) ++other;
    for (auto it = other; it != right.end() && less(it->low, one.high); ++it) {
      const Fraction low = less(one.low, it->low) ? it->low : one.low;
      const Fraction high = less(one.high, it->high) ? one.high : it->high;
      see_up_to(low);
      seen_from = high;
    }
  }
  see_up_to(end);
}

}  // namespace sightline::algorithms::exact
