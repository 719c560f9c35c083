#include "host/picture/line_metrics_near.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

#include "host/picture/line_metrics_parts.hpp"

namespace sightline::picture {
namespace {

constexpr double smallest_side = 8;
constexpr double most_squares = 256;  // in a row

double square_of_distance(const PixelSegment& segment, const PixelPoint& point) {
  const PixelPoint foot = point_at(segment, std::clamp(place_on(segment, point), 0.0, 1.0));
  const double dx = point.x - foot.x;
  const double dy = point.y - foot.y;
  return dx * dx + dy * dy;
}

}  // namespace

NearestSegment::NearestSegment(const std::vector<PixelSegment>& segments) : segments_(segments) {
  if (segments_.empty()) return;
  PixelPoint high = low_ = segments_.front().a;
  for (const PixelSegment& segment : segments_) {
    for (const PixelPoint& end : {segment.a, segment.b}) {
      low_ = {std::min(low_.x, end.x), std::min(low_.y, end.y)};
      high = {std::max(high.x, end.x), std::max(high.y, end.y)};
    }
  }
  side_ = std::max(smallest_side, std::max(high.x - low_.x, high.y - low_.y) / most_squares);
  columns_ = static_cast<int>((high.x - low_.x) / side_) + 1;
  rows_ = static_cast<int>((high.y - low_.y) / side_) + 1;
  first_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  for (const PixelSegment& segment : segments_)
    for_squares(segment, [&](std::size_t square) { ++first_[square + 1]; });
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  entries_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t i = 0; i < segments_.size(); ++i)
    for_squares(segments_[i], [&](std::size_t square) { entries_[next[square]++] = i; });
}

int NearestSegment::column_of(double x) const {
  return static_cast<int>(std::clamp((x - low_.x) / side_, 0.0, static_cast<double>(columns_ - 1)));
}

int NearestSegment::row_of(double y) const {
  return static_cast<int>(std::clamp((y - low_.y) / side_, 0.0, static_cast<double>(rows_ - 1)));
}

// Row by row: the columns that the segment has within the row, and one more on either side for rounding.
template <class Visit>
void NearestSegment::for_squares(const PixelSegment& segment, Visit&& visit) const {
  const int last = row_of(std::max(segment.a.y, segment.b.y));
  for (int row = row_of(std::min(segment.a.y, segment.b.y)); row <= last; ++row) {
    double from = std::min(segment.a.x, segment.b.x);
    double to = std::max(segment.a.x, segment.b.x);
    const double rise = segment.b.y - segment.a.y;
    if (std::abs(rise) > side_) {
      const double bottom = std::clamp((low_.y + row * side_ - segment.a.y) / rise, 0.0, 1.0);
      const double top = std::clamp((low_.y + (row + 1) * side_ - segment.a.y) / rise, 0.0, 1.0);
      from = point_at(segment, bottom).x;
      to = point_at(segment, top).x;
      if (from > to) std::swap(from, to);
    }
    const int end = std::min(column_of(to) + 1, columns_ - 1);
    for (int column = std::max(column_of(from) - 1, 0); column <= end; ++column)
      visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
            static_cast<std::size_t>(column));
  }
}

void NearestSegment::look(int column, int row, const PixelPoint& point, Found& found) const {
  if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return;
  // A segment nearest to the point inside this square is at least as far away as the square; a little less for rounding.
  const double dx = std::abs(low_.x + (column + 0.5) * side_ - point.x) - 0.501 * side_;
  const double dy = std::abs(low_.y + (row + 0.5) * side_ - point.y) - 0.501 * side_;
  const double least = (dx > 0 ? dx * dx : 0) + (dy > 0 ? dy * dy : 0);
  if (least > found.square_of_distance) return;
  const std::size_t square =
      static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  for (std::uint32_t i = first_[square]; i < first_[square + 1]; ++i) {
    const double distance = square_of_distance(segments_[entries_[i]], point);
    if (distance < found.square_of_distance) found = {entries_[i], distance};
  }
}

double NearestSegment::distance(const PixelPoint& point, std::uint32_t& nearest) const {
  if (segments_.empty()) return std::numeric_limits<double>::infinity();
  Found found{nearest, square_of_distance(segments_[nearest], point)};
  const int column = column_of(point.x);
  const int row = row_of(point.y);
  // A square of ring n is at least n - 1 sides away from every point of the middle square, and from points outside all
  // squares for which the middle one is the nearest.
  for (int ring = 0; ring <= std::max(columns_, rows_); ++ring) {
    const double least = std::max(ring - 1, 0) * side_;
    if (found.square_of_distance <= least * least) break;
    for (int c = column - ring; c <= column + ring; ++c) {
      look(c, row - ring, point, found);
      if (ring > 0) look(c, row + ring, point, found);
    }
    for (int r = row - ring + 1; r < row + ring; ++r) {
      look(column - ring, r, point, found);
      look(column + ring, r, point, found);
    }
  }
  nearest = found.segment;
  return std::sqrt(found.square_of_distance);
}

}  // namespace sightline::picture
