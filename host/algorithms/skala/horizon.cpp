#include "host/algorithms/skala/horizon.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sightline::algorithms::skala {
namespace {

// A column nothing has been drawn in: everything is above its top and below its bottom.
constexpr float untouched = 1e30F;
// A point between columns stands against masks that cut the corners of what was drawn there.
constexpr float corner_slack = 1.0F / 64;

// Columns that a segment crosses: those in (left, right], so that of two joined segments one has the column
// of their joint.
// What is right of every mask, or no number, is in no column.
constexpr float beyond_columns = 1 << 24;

int first_column(float left) {
  return left < 0 ? 0 : static_cast<int>(left < beyond_columns ? left : beyond_columns) + 1;
}
int last_column(float right) {
  return right >= 0 ? static_cast<int>(right < beyond_columns ? right : beyond_columns) : -1;
}

Vertex between(Vertex from, Vertex to, float t) {
  if (t == 1) return to;
  return {from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)};
}

class Line {
 public:
  Line(Vertex left, Vertex right) : left_(left), slope_((right.y - left.y) / (right.x - left.x)) {}
  [[nodiscard]] float at(int column) const {
    return left_.y + (static_cast<float>(column) - left_.x) * slope_;
  }

 private:
  Vertex left_;
  float slope_;
};

}  // namespace

Horizon::Horizon(int columns)
    : top_(static_cast<std::size_t>(columns), -untouched),
      bottom_(static_cast<std::size_t>(columns), untouched),
      old_top_(static_cast<std::size_t>(columns)),
      old_bottom_(static_cast<std::size_t>(columns)) {}

void Horizon::add(Vertex from, Vertex to) {
  if (!pieces_.empty() && pieces_.back().to == from) {
    pieces_.back().to = to;
  } else {
    pieces_.push_back({from, to});
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
  const int last = static_cast<int>(top_.size()) - 1;
  const int left = last_column(vertex.x);
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
void Horizon::mixed(Vertex left, Vertex right, int first, int last, float slack) {
  const Line line(left, right);
  Vertex before = left;
  Outside at_before{};
  for (int column = first; column <= last; ++column) {
    const auto i = static_cast<std::size_t>(column - first);
    const Vertex here{static_cast<float>(column), line.at(column)};
    const Outside at_here{here.y - old_top_[i] - slack, old_bottom_[i] - here.y - slack};
    gap(before, here, column == first ? at_here : at_before, at_here);
    before = here;
    at_before = at_here;
  }
  gap(before, right, at_before, at_before);
}

template <bool raising>
bool Horizon::visit(Vertex from, Vertex to, float slack, Wake& wake) {
  pieces_.clear();
  const bool leftwards = to.x < from.x;
  const Vertex left = leftwards ? to : from;
  const Vertex right = leftwards ? from : to;
  const int first = first_column(left.x);
  const int last = std::min(last_column(right.x), static_cast<int>(top_.size()) - 1);
  if (first > last) {
    narrow(from, to, slack, wake);
    return !pieces_.empty();
  }
  const Line line(left, right);
  const auto count = static_cast<std::size_t>(last - first) + 1;
  float* const top = top_.data() + first;
  float* const bottom = bottom_.data() + first;
  std::size_t above = 0;
  std::size_t below = 0;
  std::size_t either = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const float y = line.at(first + static_cast<int>(i));
    const float high = top[i];
    const float low = bottom[i];
    old_top_[i] = high;
    old_bottom_[i] = low;
    const bool over = y - high > slack;
    const bool under = low - y > slack;
    above += over ? 1 : 0;
    below += under ? 1 : 0;
    either += (over || under) ? 1 : 0;
    if constexpr (raising) {
      top[i] = y > high ? y : high;
      bottom[i] = y < low ? y : low;
    }
  }
  if constexpr (raising) {
    const std::size_t i = leftwards ? 0 : count - 1;
    wake = {leftwards ? first : last, old_top_[i], old_bottom_[i]};
  }
  if (either == 0) return false;
  if (above == count || below == count) {
    pieces_.push_back({from, to});
    return true;
  }
  mixed(left, right, first, last, slack);
  if (leftwards) {
    std::reverse(pieces_.begin(), pieces_.end());
    for (Piece& piece : pieces_) std::swap(piece.from, piece.to);
  }
  return true;
}

bool Horizon::draw(Vertex from, Vertex to, Wake& wake) {
  return visit<true>(from, to, usual_slack, wake);
}

bool Horizon::test(Vertex from, Vertex to, float slack, Wake wake) {
  return visit<false>(from, to, slack, wake);
}

void Horizon::raise(Vertex from, Vertex to) {
  const Vertex left = to.x < from.x ? to : from;
  const Vertex right = to.x < from.x ? from : to;
  const int last = std::min(last_column(right.x), static_cast<int>(top_.size()) - 1);
  const Line line(left, right);
  for (int column = first_column(left.x); column <= last; ++column) {
    const auto i = static_cast<std::size_t>(column);
    const float y = line.at(column);
    top_[i] = std::max(top_[i], y);
    bottom_[i] = std::min(bottom_[i], y);
  }
}

}  // namespace sightline::algorithms::skala
