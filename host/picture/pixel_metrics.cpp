#include "host/picture/pixel_metrics.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "host/picture/line_metrics_parts.hpp"

namespace sightline::picture {
namespace {

constexpr double boundary_distance = 0.75;

bool within(const PixelSegment& segment, const PixelPoint& point) {
  const PixelPoint foot = point_at(segment, std::clamp(place_on(segment, point), 0.0, 1.0));
  const double dx = point.x - foot.x;
  const double dy = point.y - foot.y;
  return dx * dx + dy * dy <= boundary_distance * boundary_distance;
}

// 1 for boundary pixels, found in the rows and columns near each edge.
PixelGrid boundary_of(int width, int height, const std::vector<PixelSegment>& edges) {
  PixelGrid boundary(width, height);
  const auto first = [](double value) {
    return static_cast<int>(std::max(0.0, std::ceil(value - boundary_distance)));
  };
  const auto last = [](double value, int size) {
    return static_cast<int>(std::min(std::floor(value + boundary_distance), size - 1.0));
  };
  for (const PixelSegment& edge : edges) {
    const double rise = edge.b.y - edge.a.y;
    const int end = last(std::max(edge.a.y, edge.b.y), height);
    for (int row = first(std::min(edge.a.y, edge.b.y)); row <= end; ++row) {
      double from = edge.a.x;
      double to = edge.b.x;
      if (std::abs(rise) > 2 * boundary_distance) {
        from = point_at(edge, std::clamp((row - boundary_distance - edge.a.y) / rise, 0.0, 1.0)).x;
        to = point_at(edge, std::clamp((row + boundary_distance - edge.a.y) / rise, 0.0, 1.0)).x;
      }
      const int stop = last(std::max(from, to), width);
      for (int column = first(std::min(from, to)); column <= stop; ++column)
        if (within(edge, {static_cast<double>(column), static_cast<double>(row)}))
          boundary.set(column, row, 1);
    }
  }
  return boundary;
}

// Whether none of the eight neighbours is lit.
bool alone(const PixelGrid& grid, std::size_t index) {
  const int column = static_cast<int>(index % static_cast<std::size_t>(grid.width));
  const int row = static_cast<int>(index / static_cast<std::size_t>(grid.width));
  for (int r = std::max(row - 1, 0); r <= std::min(row + 1, grid.height - 1); ++r)
    for (int c = std::max(column - 1, 0); c <= std::min(column + 1, grid.width - 1); ++c)
      if (grid.at(c, r) != 0) return false;
  return true;
}

double ratio(std::uint64_t part, std::uint64_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

}  // namespace

double PixelMetrics::mismatch() const {
  return ratio(different(), pixels);
}

double PixelMetrics::boundary_mismatch() const {
  return ratio(different_on_boundary, boundary_pixels);
}

double PixelMetrics::interior_mismatch() const {
  return ratio(different_inside, pixels - boundary_pixels);
}

PixelMetrics pixel_metrics(const PixelGrid& reference, const PixelGrid& drawn,
                           const std::vector<PixelSegment>& projected_edges) {
  assert(reference.width == drawn.width && reference.height == drawn.height);
  const PixelGrid boundary = boundary_of(reference.width, reference.height, projected_edges);
  PixelMetrics metrics;
  for (std::size_t i = 0; i < reference.values.size(); ++i) {
    const bool different = reference.values[i] != drawn.values[i];
    const bool on_boundary = boundary.values[i] != 0;
    ++metrics.pixels;
    metrics.boundary_pixels += on_boundary ? 1U : 0U;
    metrics.different_on_boundary += different && on_boundary ? 1U : 0U;
    metrics.different_inside += different && !on_boundary ? 1U : 0U;
    metrics.lit += reference.values[i] != 0 ? 1U : 0U;
    const bool missing = reference.values[i] != 0 && drawn.values[i] == 0;
    const bool extra = reference.values[i] == 0 && drawn.values[i] != 0;
    metrics.missing += missing ? 1U : 0U;
    metrics.extra += extra ? 1U : 0U;
    metrics.missing_far += missing && alone(drawn, i) ? 1U : 0U;
    metrics.extra_far += extra && alone(reference, i) ? 1U : 0U;
  }
  return metrics;
}

}  // namespace sightline::picture
