#include "host/algorithms/exact/face_shadow.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "host/geometry/rounded_fraction.hpp"

namespace sightline::algorithms::exact {
namespace {

using geometry::cross;
using geometry::dot;
using geometry::vector_of;

// The parameter at which a linear quantity is 0 that is a at the start and b at the end, of opposite signs.
template <class Number>
constexpr Fraction<Number> zero_between(const Number& a, const Number& b) {
  return a > 0 ? Fraction<Number>{a, a - b} : Fraction<Number>{-a, b - a};
}

constexpr Vector minus(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

// The two sides of a ring of four corners that cross the plane, given which corners are to its left (bits). Each side is
// given by its corner to the right and its corner to the left.
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
constexpr unsigned is_negative(const geometry::Int128& value) {
  return static_cast<unsigned>(static_cast<geometry::Unsigned128>(value) >> 127);
}

// All corners are on the same side, or (impossible for a convex face) every side crosses.
constexpr bool cannot_hide(unsigned to_left) { return to_left == 0 || to_left == all_four; }
constexpr bool alternates(unsigned to_left) { return to_left == 0b0101 || to_left == 0b1010; }

// The part of an edge beyond a plane, given the plane's values at its ends, one of which is positive.
template <class Number>
constexpr HiddenInterval<Number> beyond(const Number& a, const Number& b) {
  return {a < 0 ? zero_between(a, b) : Fraction<Number>{0, 1}, b < 0 ? zero_between(a, b) : Fraction<Number>{1, 1}};
}

}  // namespace

bool EdgeSight::begin(std::uint32_t number) {
  edge_ = view_.edges[number];
  a_ = vector_of(view_.at(edge_.from));
  b_ = vector_of(view_.at(edge_.to));
  if (!view_.perspective) {
    plane_.normal = cross(view_.forward, minus(b_, a_));
    plane_.offset = dot(plane_.normal, a_);
  } else {
    plane_ = {cross(a_, b_), 0};
  }
  return !geometry::is_zero(plane_.normal);
}

bool LineSight::begin(std::uint32_t number) {
  edge_ = view_.edges[number];
  const MeshLine& line = view_.line_of(edge_);
  const Vector eye = vector_of(view_.eye);
  for (std::size_t i = 0; i < 2; ++i) {
    planes_[i] = {line.planes[i].normal, line.planes[i].offset - dot(line.planes[i].normal, eye)};
    ends_[i] = view_.line_point(line.ends[i]);
  }
  // With d = m x n for the normals m and n: a sight x to the line has x d = (n x) m - (m x) n.
  factors_ = view_.perspective ? std::array{planes_[1].offset, -planes_[0].offset}
                               : std::array{dot(planes_[1].normal, view_.forward), -dot(planes_[0].normal, view_.forward)};
  return factors_[0] != 0 || factors_[1] != 0;
}

geometry::Rational LineSight::place(const Fraction<Number>& f) const {
  using Part = geometry::WideInteger<123>;
  using Weight = geometry::WideInteger<62>;
  const auto to = Part(f.numerator) * Weight(Number{ends_[1].weight()});
  const auto from = Part(f.denominator - f.numerator) * Weight(Number{ends_[0].weight()});
  return geometry::rounded_fraction<187>(to, from + to);
}

void LineSight::append(const Fraction<Number>& low, const Fraction<Number>& high,
                       std::vector<picture::LinePiece>& pieces) const {
  const geometry::Rational from = place(low);
  const geometry::Rational to = place(high);
  if (!pieces.empty() && pieces.back().edge == edge_ && pieces.back().high == from) {
    pieces.back().high = to;
  } else if (from < to) {
    pieces.push_back({edge_, from, to});
  }
}

template <class Sight>
bool EdgeShadow<Sight>::begin(std::uint32_t edge) {
  if (!sight_.begin(edge)) return false;
  split_ = false;
  left_.clear();
  log_.clear();
  if (view_.perspective) {
    const auto [near, far] = sight_.at_ends({view_.forward, 0});
    if (near < 0) hide({{0, 1}, zero_between(near, far)}, true, true);
    if (far < 0) hide({zero_between(near, far), {1, 1}}, true, true);
  }
  return true;
}

template <class Sight>
inline typename EdgeShadow<Sight>::Crossing EdgeShadow<Sight>::crossing(const Vector& right, const Vector& left) const {
  Plane plane{view_.perspective ? cross(right, left) : cross(view_.forward, minus(left, right)), 0};
  if (!view_.perspective) plane.offset = dot(plane.normal, right);
  const auto [at_start, at_end] = sight_.at_ends(plane);
  return {at_start, at_end};
}

template <class Sight>
bool EdgeShadow<Sight>::add(const Occluder& occluder) {
  const auto [a, b] = sight_.at_ends(occluder.plane_beyond());
  if (occluder.few_corners == 0) {
    if (a <= 0 && b <= 0) return false;
    cast_corners(occluder, beyond<Number>(a, b));
  } else {
    // The four corners are compared without a branch. A corner in the plane of the edge is on neither side.
    const auto side_of = [&](std::size_t i) { return sight_.side(occluder.corners[i].unpacked()); };
    const std::array<Number, 4> sides{side_of(0), side_of(1), side_of(2), side_of(3)};
    const unsigned left = is_negative(-sides[0]) | is_negative(-sides[1]) << 1 | is_negative(-sides[2]) << 2 |
                          is_negative(-sides[3]) << 3;
    const unsigned not_right = is_negative(~sides[0]) | is_negative(~sides[1]) << 1 | is_negative(~sides[2]) << 2 |
                               is_negative(~sides[3]) << 3;
    if ((a <= 0 && b <= 0) || (cannot_hide(left) && cannot_hide(not_right)))
      return false;
    if (alternates(left) || alternates(not_right)) {
      cast_corners(occluder, beyond<Number>(a, b));
    } else if (left == not_right) {
      cast_four(occluder, beyond<Number>(a, b), left, true, true);
    } else {
      if (!cannot_hide(left)) cast_four(occluder, beyond<Number>(a, b), left, true, false);
      if (!cannot_hide(not_right)) cast_four(occluder, beyond<Number>(a, b), not_right, false, true);
    }
  }
  return left_.whole() && (!split_ || right_.whole());
}

// For four corners, those in `to_left` to the left of the plane: exactly two sides cross it.
template <class Sight>
void EdgeShadow<Sight>::cast_four(const Occluder& occluder, const Interval& beyond, unsigned to_left, bool left,
                           bool right) {
  const CrossingSides& sides = crossing_sides[to_left];
  const auto& corners = occluder.corners;
  const Crossing one = crossing(corners[sides.right[0]].unpacked(), corners[sides.left[0]].unpacked());
  const Crossing other = crossing(corners[sides.right[1]].unpacked(), corners[sides.left[1]].unpacked());
  const bool inside = one.ahead_at_start() != other.ahead_at_start();
  const bool one_changes = one.ahead_at_start() != one.ahead_at_end();
  const bool other_changes = other.ahead_at_start() != other.ahead_at_end();
  if (!(inside | one_changes | other_changes)) return;
  std::array<Place, 2> changes;
  std::size_t count = 0;
  if (one_changes) changes[count++] = zero_between(one.at_start, one.at_end);
  if (other_changes) changes[count++] = zero_between(other.at_start, other.at_end);
  if (count == 2 && less(changes[1], changes[0])) std::swap(changes[0], changes[1]);
  hide_where(inside, std::span<const Place>(changes.data(), count), beyond, left, right);
}

// For a face with any number of corners and rings.
template <class Sight>
void EdgeShadow<Sight>::cast_corners(const Occluder& occluder, const Interval& beyond) {
  const MeshFace& face = view_.mesh->faces[occluder.face];
  sides_.resize(face.corner_count);
  Number low = 1;
  Number high = -1;
  bool touches = false;
  const Corner* const corners = view_.mesh->corners_of(face);
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const Number side = sight_.side(vector_of(view_.at(corners[i].vertex)));
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

// A corner is to the left if its value is at least `threshold`.
template <class Sight>
void EdgeShadow<Sight>::cast(const Occluder& occluder, const Interval& beyond, const Number& threshold,
                             bool left, bool right) {
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
  std::sort(changes_.begin(), changes_.end(), [](const Place& a, const Place& b) { return less(a, b); });
  hide_where(inside, changes_, beyond, left, right);
}

// The face covers the start of the edge if `inside`, and this changes at each of `changes`, which ascend.
template <class Sight>
void EdgeShadow<Sight>::hide_where(bool inside, std::span<const Place> changes, const Interval& beyond, bool left,
                            bool right) {
  Place low = beyond.low;
  for (const Place& change : changes) {
    if (inside) hide({low, less(change, beyond.high) ? change : beyond.high}, left, right);
    inside = !inside;
    if (less(low, change)) low = change;
  }
  if (inside) hide({low, beyond.high}, left, right);
}

template <class Sight>
void EdgeShadow<Sight>::hide(const Interval& interval, bool left, bool right) {
  if (keeps_log_) log_.push_back({interval, left, right});
  if (left != right && !split_) {
    split_ = true;
    right_ = left_;
  }
  if (left || !split_) left_.add(interval.low, interval.high);
  if (right && split_) right_.add(interval.low, interval.high);
}

// A part is hidden if it is hidden from both sides; the gaps between hidden parts are visible.
template <class Sight>
void EdgeShadow<Sight>::append_visible(std::vector<picture::LinePiece>& pieces) const {
  Place seen_from{0, 1};
  const auto see_up_to = [&](const Place& low) {
    if (less(seen_from, low)) sight_.append(seen_from, low, pieces);
  };
  const auto& right = split_ ? right_.intervals() : left_.intervals();
  auto other = right.begin();
  for (const Interval& one : left_.intervals()) {
    while (other != right.end() && !less(one.low, other->high)) ++other;
    for (auto it = other; it != right.end() && less(it->low, one.high); ++it) {
      const Place low = less(one.low, it->low) ? it->low : one.low;
      const Place high = less(one.high, it->high) ? one.high : it->high;
      see_up_to(low);
      seen_from = high;
    }
  }
  see_up_to({1, 1});
}

template class EdgeShadow<EdgeSight>;
template class EdgeShadow<LineSight>;

}  // namespace sightline::algorithms::exact
