#include "host/algorithms/exact/face_shadow.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace sightline::algorithms::exact {
namespace {

using geometry::cross;
using geometry::dot;
using geometry::vector_of;

constexpr Fraction start{0, 1};
constexpr Fraction end{1, 1};

// Where a quantity vanishes that is a at the start and b at the end, of opposite signs.
constexpr Fraction zero_between(std::int64_t a, std::int64_t b) {
  return a > 0 ? Fraction{a, a - b} : Fraction{-a, b - a};
}

constexpr Vector minus(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

constexpr geometry::Rational rational(const Fraction& f) {
  return {f.numerator, f.denominator};
}

// Of a ring of four corners: the two sides that cross from the corners to the right to those to the left (bits), each
// given by its corner to the right and that to the left.
struct CrossingSides {
  std::array<std::uint8_t, 2> right{};
  std::array<std::uint8_t, 2> left{};
};

constexpr unsigned all_four = 0b1111;

constexpr std::array<CrossingSides, 16> find_crossing_sides() {
  std::array<CrossingSides, 16> table{};
  for (unsigned to_left = 0; to_left < table.size(); ++to_left) {
    std::size_t count = 0;
    for (unsigned i = 0; i < 4; ++i) {
      const unsigned next = (i + 1) % 4;
      const bool leaves = ((to_left >> i) & 1U) != 0;
      if (leaves == (((to_left >> next) & 1U) != 0) || count == 2) continue;
      table[to_left].right[count] = static_cast<std::uint8_t>(leaves ? next : i);
      table[to_left].left[count] = static_cast<std::uint8_t>(leaves ? i : next);
      ++count;
    }
  }
  return table;
}

constexpr std::array<CrossingSides, 16> crossing_sides = find_crossing_sides();

constexpr unsigned is_negative(std::int64_t value) {
  return static_cast<unsigned>(static_cast<std::uint64_t>(value) >> 63);
}

// All corners are to the same side; or each side crosses, which a convex face has not.
constexpr bool is_apart(unsigned to_left) { return to_left == 0 || to_left == all_four; }
constexpr bool alternates(unsigned to_left) { return to_left == 0b0101 || to_left == 0b1010; }

// The part of an edge beyond a plane on which its ends have these values, one of them positive.
constexpr HiddenInterval beyond(std::int64_t a, std::int64_t b) {
  return {a < 0 ? zero_between(a, b) : start, b < 0 ? zero_between(a, b) : end};
}

}  // namespace

bool EdgeShadow::begin(const picture::LineEdge& edge) {
  edge_ = edge;
  a_ = vector_of(view_.at(edge.from));
  b_ = vector_of(view_.at(edge.to));
  split_ = false;
  left_.clear();
  if (!view_.perspective) {
    plane_.normal = cross(view_.forward, minus(b_, a_));
    plane_.offset = dot(plane_.normal, a_);
    return !geometry::is_zero(plane_.normal);
  }
  plane_ = {cross(a_, b_), 0};
  const std::int64_t near = dot(view_.forward, a_);
  const std::int64_t far = dot(view_.forward, b_);
  if (near < 0) left_.add(start, zero_between(near, far));
  if (far < 0) left_.add(zero_between(near, far), end);
  return !geometry::is_zero(plane_.normal);
}

inline EdgeShadow::Crossing EdgeShadow::crossing(const Vector& right, const Vector& left) const {
  if (view_.perspective) {
    const Vector normal = cross(right, left);
    return {dot(normal, a_), dot(normal, b_)};
  }
  const Vector normal = cross(view_.forward, minus(left, right));
  const std::int64_t offset = dot(normal, right);
  return {dot(normal, a_) - offset, dot(normal, b_) - offset};
}

bool EdgeShadow::add(const Occluder& occluder) {
  const Plane plane = occluder.plane_beyond();
  const std::int64_t a = plane.at(a_);
  const std::int64_t b = plane.at(b_);
  if (occluder.few_corners == 0) {
    if (a <= 0 && b <= 0) return false;
    cast_corners(occluder, beyond(a, b));
  } else {
    // Four corners are compared without a branch; one that is on the plane of the edge is on neither side.
    const auto side_of = [&](std::size_t i) { return plane_.at(occluder.corners[i].unpacked()); };
    const std::array<std::int64_t, 4> sides{side_of(0), side_of(1), side_of(2), side_of(3)};
    const unsigned left = is_negative(-sides[0]) | is_negative(-sides[1]) << 1 | is_negative(-sides[2]) << 2 |
                          is_negative(-sides[3]) << 3;
    const unsigned not_right = is_negative(~sides[0]) | is_negative(~sides[1]) << 1 | is_negative(~sides[2]) << 2 |
                               is_negative(~sides[3]) << 3;
    if ((a <= 0 && b <= 0) || (is_apart(left) && is_apart(not_right)))
      return false;
    if (alternates(left) || alternates(not_right)) {
      cast_corners(occluder, beyond(a, b));
    } else if (left == not_right) {
      cast_four(occluder, beyond(a, b), left, true, true);
    } else {
      if (!is_apart(left)) cast_four(occluder, beyond(a, b), left, true, false);
      if (!is_apart(not_right)) cast_four(occluder, beyond(a, b), not_right, false, true);
    }
  }
  return left_.whole() && (!split_ || right_.whole());
}

// The corners `to_left` of the plane, of four: two sides cross it.
void EdgeShadow::cast_four(const Occluder& occluder, const HiddenInterval& beyond, unsigned to_left, bool left,
                           bool right) {
  const CrossingSides& sides = crossing_sides[to_left];
  const auto& corners = occluder.corners;
  const Crossing one = crossing(corners[sides.right[0]].unpacked(), corners[sides.left[0]].unpacked());
  const Crossing other = crossing(corners[sides.right[1]].unpacked(), corners[sides.left[1]].unpacked());
  const bool inside = one.ahead_at_start() != other.ahead_at_start();
  const bool one_changes = one.ahead_at_start() != one.ahead_at_end();
  const bool other_changes = other.ahead_at_start() != other.ahead_at_end();
  if (!(inside | one_changes | other_changes)) return;
  std::array<Fraction, 2> changes;
  std::size_t count = 0;
  if (one_changes) changes[count++] = zero_between(one.at_start, one.at_end);
  if (other_changes) changes[count++] = zero_between(other.at_start, other.at_end);
  if (count == 2 && less(changes[1], changes[0])) std::swap(changes[0], changes[1]);
  hide_where(inside, std::span(changes).first(count), beyond, left, right);
}

// A face of any corners and rings.
void EdgeShadow::cast_corners(const Occluder& occluder, const HiddenInterval& beyond) {
  const MeshFace& face = view_.mesh->faces[occluder.face];
  sides_.resize(face.corner_count);
  std::int64_t low = 1;
  std::int64_t high = -1;
  bool touches = false;
  const Corner* const corners = view_.mesh->corners_of(face);
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const std::int64_t side = plane_.at(vector_of(view_.at(corners[i].vertex)));
    sides_[i] = side;
    low = std::min(low, side);
    high = std::max(high, side);
    touches = touches || side == 0;
  }
  if (low > 0 || high < 0) return;
  if (touches) {
    if (high > 0) cast(occluder, beyond, 1, true, false);
    if (low < 0) cast(occluder, beyond, 0, false, true);
  } else {
    cast(occluder, beyond, 0, true, true);
  }
}

// `threshold`: from which value on a corner counts as to the left.
void EdgeShadow::cast(const Occluder& occluder, const HiddenInterval& beyond, std::int64_t threshold, bool left,
                      bool right) {
  const MeshFace& face = view_.mesh->faces[occluder.face];
  const Corner* const corners = view_.mesh->corners_of(face);
  bool inside = false;
  changes_.clear();
  for_sides(corners, face.corner_count, [&](std::uint32_t i, std::uint32_t next) {
    const bool leaves = sides_[i] >= threshold;
    if (leaves == (sides_[next] >= threshold)) return;
    const Vector from = vector_of(view_.at(corners[i].vertex));
    const Vector to = vector_of(view_.at(corners[next].vertex));
    const Crossing side = leaves ? crossing(to, from) : crossing(from, to);
    if (side.ahead_at_start()) inside = !inside;
    if (side.ahead_at_start() != side.ahead_at_end()) changes_.push_back(zero_between(side.at_start, side.at_end));
  });
  std::sort(changes_.begin(), changes_.end(), less);
  hide_where(inside, changes_, beyond, left, right);
}

// The face covers the edge from its start on if `inside`, and changes that at each of `changes`, which ascend.
void EdgeShadow::hide_where(bool inside, std::span<const Fraction> changes, const HiddenInterval& beyond, bool left,
                            bool right) {
  Fraction low = beyond.low;
  for (const Fraction& change : changes) {
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
  Fraction seen_from = start;
  const auto see_up_to = [&](const Fraction& low) {
    if (less(seen_from, low)) pieces.push_back({edge_, rational(seen_from), rational(low)});
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
