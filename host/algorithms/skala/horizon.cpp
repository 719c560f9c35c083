#include "host/algorithms/skala/horizon.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

namespace sightline::algorithms::skala {
namespace {

// A column nothing has been drawn in: everything is above its top and below its bottom.
constexpr float untouched = 1e30F;
// A point between columns is compared with masks that cut the corners of what was drawn there.
constexpr float corner_slack = 1.0F / 64;

// The last column not right of x, -1 if none. Without a branch: where lines go is as good as random.
int column_before(float x, float last) {
  const float within = std::max(x < last ? x : last, -0.5F);
  return static_cast<int>(within) - static_cast<int>(within < 0);
}

Vertex between(Vertex from, Vertex to, float t) {
  if (t == 1) return to;
  return {from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)};
}

// Four columns at once, for which any of the compilers has instructions or makes them up.
using Floats = float __attribute__((vector_size(16)));
using Ints = std::int32_t __attribute__((vector_size(16)));

Floats load(const float* from) {
  Floats values;
  std::memcpy(&values, from, sizeof values);
  return values;
}
void store(const Floats& values, float* to) {
  std::memcpy(to, &values, sizeof values);
}
// By masks of ones or zeros.
Floats either(Ints first, Floats a, Floats b) {
  return std::bit_cast<Floats>((first & std::bit_cast<Ints>(a)) | (~first & std::bit_cast<Ints>(b)));
}

// The sum of four numbers that do not add up to more than 32 bits.
std::uint32_t sum_of(Ints numbers) {
  const auto pairs = std::bit_cast<std::array<std::uint64_t, 2>>(numbers);
  const std::uint64_t sum = pairs[0] + pairs[1];
  return static_cast<std::uint32_t>(sum) + static_cast<std::uint32_t>(sum >> 32);
}
bool any_of(Ints mask) {
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

}  // namespace

Horizon::Horizon(int columns)
    : columns_(static_cast<std::size_t>(columns)),
      top_(columns_ + block, -untouched),
      bottom_(columns_ + block, untouched),
      heights_(static_cast<std::size_t>(columns) + block),
      seen_before_(static_cast<std::size_t>(columns) + 1) {}

void Horizon::add(Vertex from, Vertex to) {
  if (pieces_.size() > first_own_ && pieces_.back().to == from) {
    pieces_.back().to = to;
  } else {
    see(from, to);
  }
}

// Both differences are straight between the two points.
void Horizon::gap(Vertex from, Vertex to, Outside a, Outside b) {
  const bool untouched_columns = (a.above > 0 && a.below > 0) || (b.above > 0 && b.below > 0);
  const bool all = untouched_columns || (a.above > 0 && b.above > 0) || (a.below > 0 && b.below > 0);
  if (all) return add(from, to);
  const float meets_top = a.above / (a.above - b.above);
  const float meets_bottom = a.below / (a.below - b.below);
  if (a.above > 0) add(from, between(from, to, meets_top));
  if (a.below > 0) add(from, between(from, to, meets_bottom));
  if (b.above > 0) add(between(from, to, meets_top), to);
  if (b.below > 0) add(between(from, to, meets_bottom), to);
}

Horizon::Outside Horizon::outside(Vertex vertex, float slack, const Wake& wake) const {
  const int last = static_cast<int>(columns_) - 1;
  const int left = column_before(vertex.x, static_cast<float>(last));
  const auto top = [&](int column) {
    return column == wake.column ? wake.top : top_[static_cast<std::size_t>(column)];
  };
  const auto bottom = [&](int column) {
    return column == wake.column ? wake.bottom : bottom_[static_cast<std::size_t>(column)];
  };
  const int a = std::clamp(left, 0, last);
  const int b = std::clamp(left + 1, 0, last);
  const float t = std::clamp(vertex.x - static_cast<float>(a), 0.0F, 1.0F);
  const float high = t == 0 ? top(a) : top(a) + t * (top(b) - top(a));
  const float low = t == 0 ? bottom(a) : bottom(a) + t * (bottom(b) - bottom(a));
  return {vertex.y - high - slack, low - vertex.y - slack};
}

// A line that leaves the horizon begins on it.
void Horizon::narrow(Vertex from, Vertex to, float slack, const Wake& wake) {
  const auto touching = [slack](Outside where) {
    if (slack < 0) return where;
    return Outside{std::abs(where.above) <= corner_slack ? 0 : where.above,
                   std::abs(where.below) <= corner_slack ? 0 : where.below};
  };
  const float taken = std::min(slack, 0.0F);
  gap(from, to, touching(outside(from, taken, wake)), touching(outside(to, taken, wake)));
}

// The ends, beyond the outermost columns, are as these.
void Horizon::mixed(Vertex left, Vertex right, Columns columns, bool leftwards, float slack) {
  Vertex before = left;
  Outside at_before{};
  for (int column = columns.first; column <= columns.last; ++column) {
    const auto i = static_cast<std::size_t>(column);
    const Vertex here{static_cast<float>(column), heights_[i]};
    const Outside at_here{here.y - top_[i] - slack, bottom_[i] - here.y - slack};
    gap(before, here, column == columns.first ? at_here : at_before, at_here);
    before = here;
    at_before = at_here;
  }
  gap(before, right, at_before, at_before);
  if (!leftwards) return;
  const auto own = pieces_.begin() + static_cast<std::ptrdiff_t>(first_own_);
  std::reverse(own, pieces_.end());
  std::for_each(own, pieces_.end(), [](Piece& piece) { std::swap(piece.from, piece.to); });
}

// Those in (left, right], so that of two joined segments one has the column of their joint.
inline Horizon::Columns Horizon::columns_of(Vertex left, Vertex right) const {
  const auto last = static_cast<float>(columns_ - 1);
  return {column_before(left.x, last) + 1, column_before(right.x, last)};
}

// Adds the visible pieces and leaves the segment's height in every column it crosses.
Horizon::Columns Horizon::look(Vertex from, Vertex to, float slack, const Wake& wake) {
  first_own_ = pieces_.size();
  const bool leftwards = to.x < from.x;
  const Vertex left = leftwards ? to : from;
  const Vertex right = leftwards ? from : to;
  const Columns columns = columns_of(left, right);
  if (columns.first > columns.last) {
    narrow(from, to, slack, wake);
    return columns;
  }
  const Line line(left, right);
  int above = 0;
  int below = 0;
  int either = 0;
  for (int column = columns.first; column <= columns.last; ++column) {
    const auto i = static_cast<std::size_t>(column);
    const float y = line.at(column);
    heights_[i] = y;
    const int over = y - top_[i] > slack ? 1 : 0;
    const int under = bottom_[i] - y > slack ? 1 : 0;
    above += over;
    below += under;
    either |= over | under;
  }
  if (either == 0) return columns;
  const int count = columns.last - columns.first + 1;
  if (above == count || below == count) {
    see(from, to);
  } else {
    mixed(left, right, columns, leftwards, slack);
  }
  return columns;
}

// By the heights that look() left.
void Horizon::raise(Columns columns, bool leftwards, Wake& wake) {
  if (columns.first > columns.last) return;
  const auto first = static_cast<std::size_t>(columns.first);
  const auto last = static_cast<std::size_t>(columns.last);
  const std::size_t end = leftwards ? first : last;
  wake = {static_cast<int>(end), top_[end], bottom_[end]};
  for (std::size_t i = first; i <= last; ++i) {
    top_[i] = std::max(top_[i], heights_[i]);
    bottom_[i] = std::min(bottom_[i], heights_[i]);
  }
}

// look() and raise() for a segment in at most a block of columns. Most segments of a net are so short, and how many
// columns they have is as good as random: a block is worked on as a whole, without a branch on it, and what is beyond the
// segment is left out of the sums and as it was in the masks.
inline void Horizon::draw_short(Vertex from, Vertex to, Columns columns, Wake& wake) {
  const bool leftwards = to.x < from.x;
  const Vertex left = leftwards ? to : from;
  const Vertex right = leftwards ? from : to;
  const Line line(left, right);
  const auto first = static_cast<std::size_t>(columns.first);
  const int count = columns.last - columns.first + 1;
  const Floats top = load(&top_[first]);
  const Floats bottom = load(&bottom_[first]);
  const Floats heights = line.at(Floats{0, 1, 2, 3} + static_cast<float>(columns.first));
  const Ints own = Ints{0, 1, 2, 3} < count;
  const Ints over = (heights - top > usual_slack) & own;
  const Ints under = (bottom - heights > usual_slack) & own;
  constexpr std::int32_t below_bottom = 1 << 8;  // above any sum of ones
  const Ints flags = (over & 1) | (under & below_bottom);
  if (const std::uint32_t seen = sum_of(flags); seen != 0) {
    const auto all = static_cast<std::uint32_t>(count);
    if (seen % below_bottom == all || seen / below_bottom == all) {
      see(from, to);
    } else {
      store(heights, &heights_[first]);
      mixed(left, right, columns, leftwards, usual_slack);
    }
  }
  const auto end = static_cast<std::size_t>(leftwards ? columns.first : columns.last);
  wake = {static_cast<int>(end), top_[end], bottom_[end]};
  // The next segment loads some of these columns: it must not wait for what was stored unchanged.
  const Ints higher = (top < heights) & own;
  const Ints lower = (heights < bottom) & own;
  if (any_of(higher)) store(either(higher, heights, top), &top_[first]);
  if (any_of(lower)) store(either(lower, heights, bottom), &bottom_[first]);
}

bool Horizon::draw(Vertex from, Vertex to, Wake& wake) {
  pieces_.clear();
  const bool leftwards = to.x < from.x;
  const Columns columns = leftwards ? columns_of(to, from) : columns_of(from, to);
  if (columns.first <= columns.last && columns.last - columns.first < static_cast<int>(block)) {
    first_own_ = 0;
    draw_short(from, to, columns, wake);
  } else {
    raise(look(from, to, usual_slack, wake), leftwards, wake);
  }
  return !pieces_.empty();
}

bool Horizon::test(Vertex from, Vertex to, float slack, Wake wake) {
  pieces_.clear();
  look(from, to, slack, wake);
  return !pieces_.empty();
}

}  // namespace sightline::algorithms::skala
