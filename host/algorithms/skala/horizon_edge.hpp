// Horizon::draw_edge, which processes every edge of a net. It is in a header so that it can be inlined into the loop over
// the edges. Only horizon.cpp and walk.cpp include it.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "host/algorithms/skala/horizon.hpp"

namespace sightline::algorithms::skala {
namespace edge {

// The last column not right of x, -1 if none. Has no branches, because the direction of lines is unpredictable.
inline int column_before(float x, float last) {
  const float within = std::max(x < last ? x : last, -0.5F);
  return static_cast<int>(within) - static_cast<int>(within < 0);
}

// Four columns at a time: every compiler has instructions for this or emulates them.
using Floats = float __attribute__((vector_size(16)));
using Ints = std::int32_t __attribute__((vector_size(16)));

inline Floats load(const float* from) {
  Floats values;
  std::memcpy(&values, from, sizeof values);
  return values;
}
inline void store(const Floats& values, float* to) {
  std::memcpy(to, &values, sizeof values);
}
// Selects a where `first` has all bits set, and b where it is 0.
inline Floats either(Ints first, Floats a, Floats b) {
  return std::bit_cast<Floats>((first & std::bit_cast<Ints>(a)) | (~first & std::bit_cast<Ints>(b)));
}

// The sum of four numbers; it must fit in 32 bits.
inline std::uint32_t sum_of(Ints numbers) {
  const auto pairs = std::bit_cast<std::array<std::uint64_t, 2>>(numbers);
  const std::uint64_t sum = pairs[0] + pairs[1];
  return static_cast<std::uint32_t>(sum) + static_cast<std::uint32_t>(sum >> 32);
}
inline bool any_of(Ints mask) {
  const auto pairs = std::bit_cast<std::array<std::uint64_t, 2>>(mask);
  return (pairs[0] | pairs[1]) != 0;
}

class Line {
 public:
  Line(Vertex left, Vertex right) : left_(left), slope_((right.y - left.y) / (right.x - left.x)) {}
  [[nodiscard]] float at(int column) const {
    return left_.y + (static_cast<float>(column) - left_.x) * slope_;
  }
  [[nodiscard]] Floats at(Floats columns) const { return left_.y + (columns - left_.x) * slope_; }

 private:
  Vertex left_;
  float slope_;
};

}  // namespace edge

// Most segments of a net cross at most a block of columns, and how many is unpredictable. Therefore a whole block is
// processed without branching on that number; columns beyond the segment do not count and are left unchanged in the
// masks.
inline Horizon::Sight Horizon::draw_edge(Vertex from, Vertex to, int before_from, int before_to, Wake& wake) {
  using edge::Floats;
  using edge::Ints;
  const bool leftwards = to.x < from.x;
  const Vertex left = leftwards ? to : from;
  const Vertex right = leftwards ? from : to;
  // The columns in (left, right], so that the column of a joint belongs to only one of the two segments.
  const Columns columns{(leftwards ? before_to : before_from) + 1, leftwards ? before_from : before_to};
  const int count = columns.last - columns.first + 1;
  if (static_cast<unsigned>(count - 1) >= block) return draw_long(from, to, leftwards, wake);
  const edge::Line line(left, right);
  const auto first = static_cast<std::size_t>(columns.first);
  const Floats top = edge::load(&top_[first]);
  const Floats bottom = edge::load(&bottom_[first]);
  const Floats heights = line.at(Floats{0, 1, 2, 3} + static_cast<float>(columns.first));
  const Ints own = Ints{0, 1, 2, 3} < count;
  const Ints over = (heights - top > usual_slack) & own;
  const Ints under = (bottom - heights > usual_slack) & own;
  constexpr std::int32_t below_bottom = 1 << 8;  // exceeds any sum of ones
  const Ints flags = (over & 1) | (under & below_bottom);
  Sight sight = Sight::hidden;
  if (const std::uint32_t seen = edge::sum_of(flags); seen != 0) {
    const auto all = static_cast<std::uint32_t>(count);
    if (seen % below_bottom == all || seen / below_bottom == all) {
      sight = Sight::whole;
    } else {
      sight = Sight::parts;
      edge::store(heights, &heights_[first]);
      pieces_.clear();
      first_own_ = 0;
      mixed(left, right, columns, leftwards, usual_slack);
    }
  }
  const auto end = static_cast<std::size_t>(leftwards ? columns.first : columns.last);
  wake = {static_cast<int>(end), top_[end], bottom_[end]};
  // The next segment loads some of these columns and must not wait for stores that change nothing.
  const Ints higher = (top < heights) & own;
  const Ints lower = (heights < bottom) & own;
  if (edge::any_of(higher)) edge::store(edge::either(higher, heights, top), &top_[first]);
  if (edge::any_of(lower)) edge::store(edge::either(lower, heights, bottom), &bottom_[first]);
  return sight;
}

}  // namespace sightline::algorithms::skala
