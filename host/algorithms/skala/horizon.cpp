#include "host/algorithms/skala/horizon.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "host/algorithms/skala/horizon_edge.hpp"

namespace sightline::algorithms::skala {
namespace {

// A column without drawing: everything is above its top and below its bottom.
constexpr float untouched = 1e30F;
// Between columns, the masks cut the corners of what was drawn there.
constexpr float corner_slack = 1.0F / 64;

Vertex between(Vertex from, Vertex to, float t) {
  if (t == 1) return to;
  return {from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)};
}

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

// Both differences are linear between the two points.
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
  const int left = edge::column_before(vertex.x, static_cast<float>(last));
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

// A line that leaves the horizon begins on it, so small differences count as 0.
void Horizon::narrow(Vertex from, Vertex to, float slack, const Wake& wake) {
  const auto touching = [slack](Outside where) {
    if (slack < 0) return where;
    return Outside{std::abs(where.above) <= corner_slack ? 0 : where.above,
                   std::abs(where.below) <= corner_slack ? 0 : where.below};
  };
  const float taken = std::min(slack, 0.0F);
  gap(from, to, touching(outside(from, taken, wake)), touching(outside(to, taken, wake)));
}

// The ends are beyond the outermost crossed columns and have the same state as those.
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

// Adds the visible pieces and stores the segment's height in every column that it crosses.
Horizon::Columns Horizon::look(Vertex from, Vertex to, float slack, const Wake& wake) {
  first_own_ = pieces_.size();
  const bool leftwards = to.x < from.x;
  const Vertex left = leftwards ? to : from;
  const Vertex right = leftwards ? from : to;
  const auto last = static_cast<float>(columns_ - 1);
  const Columns columns{edge::column_before(left.x, last) + 1, edge::column_before(right.x, last)};
  if (columns.first > columns.last) {
    narrow(from, to, slack, wake);
    return columns;
  }
  const edge::Line line(left, right);
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

// Uses the heights that look() stored.
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

// For a segment that crosses no column, or more than a block.
Horizon::Sight Horizon::draw_long(Vertex from, Vertex to, bool leftwards, Wake& wake) {
  pieces_.clear();
  raise(look(from, to, usual_slack, wake), leftwards, wake);
  return pieces_.empty() ? Sight::hidden : Sight::parts;
}

bool Horizon::draw(Vertex from, Vertex to, Wake& wake) {
  pieces_.clear();
  const auto last = static_cast<float>(columns_ - 1);
  const Sight seen =
      draw_edge(from, to, edge::column_before(from.x, last), edge::column_before(to.x, last), wake);
  if (seen == Sight::whole) see(from, to);
  return !pieces_.empty();
}

void Horizon::find_columns(std::span<const Vertex> vertices, std::vector<std::int32_t>& columns) const {
  columns.resize(vertices.size());
  const auto last = static_cast<float>(columns_ - 1);
  for (std::size_t i = 0; i < vertices.size(); ++i) columns[i] = edge::column_before(vertices[i].x, last);
}

bool Horizon::test(Vertex from, Vertex to, float slack, Wake wake) {
  pieces_.clear();
  look(from, to, slack, wake);
  return !pieces_.empty();
}

}  // namespace sightline::algorithms::skala
