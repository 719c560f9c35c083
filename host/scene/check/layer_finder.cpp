// See layer_finder.hpp.
#include "host/scene/check/layer_finder.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <utility>

namespace sightline::scene {

bool LayerFinder::is_layer(std::span<const Triangle> triangles) {
  const unsigned viewers = viewers_of(triangles);
  if (viewers == 0 || !find_outline(triangles, static_cast<unsigned>(std::countr_zero(viewers)))) return false;
  for (std::size_t i = 0; i < outline_.size(); ++i)
    for (std::size_t j = i + 1; j < outline_.size(); ++j)
      if (meet(outline_[i], outline_[j])) return false;
  return std::all_of(outline_.begin(), outline_.end(), [this](const Side& side) { return covering(side) == 1; });
}

unsigned LayerFinder::viewers_of(std::span<const Triangle> triangles) const {
  unsigned all = 0x3F;
  for (const auto& [a, b, c] : triangles) {
    unsigned viewers = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto point = [this, k](VertexIndex v) { return Point{vertices_[v][(k + 1) % 3], vertices_[v][(k + 2) % 3]}; };
      const std::int64_t turned = turn(point(a), point(b), point(c));
      viewers |= ((turned > 0 ? 1U : 0U) | (turned < 0 ? 2U : 0U)) << (2 * k);
    }
    all &= viewers;
    if (all == 0) break;
  }
  return all;
}

void LayerFinder::count_edge(VertexIndex from, VertexIndex to) {
  const std::uint64_t ends = std::uint64_t{std::min(from, to)} << 32 | std::max(from, to);
  const std::size_t last = table_.size() - 1;
  std::size_t place = (ends * 0x9E3779B97F4A7C15U >> 32) & last;
  while (table_[place].ends != ends && table_[place].ends != 0) place = (place + 1) & last;
  if (table_[place].ends == 0) {
    table_[place] = {ends, 0};
    used_.push_back(static_cast<std::uint32_t>(place));
  }
  table_[place].surplus += from < to ? 1 : -1;
}

bool LayerFinder::find_outline(std::span<const Triangle> triangles, unsigned viewer) {
  table_.resize(std::max(table_.size(), std::bit_ceil(4 * triangles.size())));
  for (const Triangle& corners : triangles)
    for (std::size_t i = 0; i < 3; ++i) count_edge(corners[i], corners[(i + 1) % 3]);
  // The corners of a front are seen in a turn to the left: the viewer at +x has y to the right and z upwards, the one at -x the reverse.
  std::size_t right = (viewer / 2 + 1) % 3;
  std::size_t up = (viewer / 2 + 2) % 3;
  if (viewer % 2 == 1) std::swap(right, up);
  outline_.clear();
  bool fits = true;
  for (const std::uint32_t place : used_) {
    const Edge edge = std::exchange(table_[place], {});
    if (edge.surplus == 0) continue;
    fits = fits && std::abs(edge.surplus) == 1 && outline_.size() < triangles.size() + 2;  // connected triangles have no more sides
    if (!fits) continue;
    Side& side = outline_.emplace_back();
    side.vertices = {static_cast<VertexIndex>(edge.ends >> 32), static_cast<VertexIndex>(edge.ends)};
    if (edge.surplus < 0) std::swap(side.vertices[0], side.vertices[1]);
    for (std::size_t end = 0; end < 2; ++end) {
      const PolyPoint& p = vertices_[side.vertices[end]];
      side.ends[end] = {p[right], p[up]};
    }
    side.low = {std::min(side.ends[0].right, side.ends[1].right), std::min(side.ends[0].up, side.ends[1].up)};
    side.high = {std::max(side.ends[0].right, side.ends[1].right), std::max(side.ends[0].up, side.ends[1].up)};
  }
  used_.clear();
  return fits;
}

bool LayerFinder::meet(const Side& a, const Side& b) {
  if (a.low.right > b.high.right || b.low.right > a.high.right || a.low.up > b.high.up || b.low.up > a.high.up) return false;
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      if (a.vertices[i] != b.vertices[j]) continue;
      const Point& corner = a.ends[i];
      const Point& one = a.ends[1 - i];
      const Point& other = b.ends[1 - j];
      return turn(corner, one, other) == 0 && (one.right - corner.right) * (other.right - corner.right) +
                                                      (one.up - corner.up) * (other.up - corner.up) > 0;
    }
  }
  const auto on_one_side = [](const Side& line, const Side& side) {
    const std::int64_t first = turn(line.ends[0], line.ends[1], side.ends[0]);
    const std::int64_t second = turn(line.ends[0], line.ends[1], side.ends[1]);
    return (first > 0 && second > 0) || (first < 0 && second < 0);
  };
  return !on_one_side(a, b) && !on_one_side(b, a);
}

int LayerFinder::covering(const Side& side) const {
  const auto doubled = [](const Point& p) { return Point{2 * p.right, 2 * p.up}; };
  const Point middle{side.ends[0].right + side.ends[1].right, side.ends[0].up + side.ends[1].up};
  // The sides that a line from the middle to the right crosses, just above their lower and up to their upper ends.
  const bool crosses_itself = side.ends[0].up < side.ends[1].up || (side.ends[0].up == side.ends[1].up && side.ends[0].right > side.ends[1].right);
  int count = crosses_itself ? 1 : 0;
  for (const Side& other : outline_) {
    if (&other == &side) continue;
    const bool from_below = 2 * other.ends[0].up <= middle.up;
    const bool to_below = 2 * other.ends[1].up <= middle.up;
    if (from_below == to_below) continue;
    const std::int64_t at = turn(doubled(other.ends[0]), doubled(other.ends[1]), middle);
    if (from_below && at > 0) ++count;
    if (to_below && at < 0) --count;
  }
  return count;
}

}  // namespace sightline::scene
