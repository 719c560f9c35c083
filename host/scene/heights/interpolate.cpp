#include "host/scene/heights/interpolate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

#include "host/geometry/predicates.hpp"
#include "host/scene/heights/delaunay.hpp"
#include "host/scene/heights/read_text.hpp"

namespace sightline::scene {
namespace {

using geometry::Point2;

constexpr double rounded_extent = 1 << 17;

struct RoundingScale {
  Interval domain;

  // From 0 to rounded_extent. Halves, since a difference may be beyond the greatest double.
  [[nodiscard]] std::int32_t rounded(double value) const {
    const double part = (value / 2 - domain.low / 2) / (domain.high / 2 - domain.low / 2);
    return static_cast<std::int32_t>(std::lround(part * rounded_extent));
  }
};

Interval extent_of(const std::vector<ScatteredPoint>& points, double ScatteredPoint::*axis) {
  const auto [low, high] =
      std::minmax_element(points.begin(), points.end(), [axis](const auto& a, const auto& b) { return a.*axis < b.*axis; });
  return {(*low).*axis, (*high).*axis};
}

struct SampleCorner {
  double x = 0;
  double y = 0;
  double height = 0;
};

// Fills in the heights of a grid, which begin as holes.
class TriangleFiller {
 public:
  explicit TriangleFiller(HeightGrid& grid) : grid_(grid) {}

  // A place on a side shared by two triangles has the height of either.
  void fill(const std::array<SampleCorner, 3>& corners) {
    const auto [low, high] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
    for (std::size_t slice = first_at(low, grid_.slices()); slice <= last_at(high, grid_.slices()); ++slice)
      fill_slice(corners, slice);
  }

 private:
  // Sides of triangles may miss a place by rounding alone.
  static constexpr double slack = 1e-6;

  static double place_of(std::size_t i, std::size_t count) {
    return rounded_extent * static_cast<double>(i) / static_cast<double>(count - 1);
  }
  static std::size_t first_at(double place, std::size_t count) {
    return static_cast<std::size_t>(std::max(0.0, std::ceil((place - slack) / rounded_extent * static_cast<double>(count - 1))));
  }
  static std::size_t last_at(double place, std::size_t count) {
    const double at = std::floor((place + slack) / rounded_extent * static_cast<double>(count - 1));
    return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(count - 1)));
  }

  void fill_slice(const std::array<SampleCorner, 3>& corners, std::size_t slice) {
    const double y = place_of(slice, grid_.slices());
    double left = std::numeric_limits<double>::infinity();
    double right = -left;
    for (std::size_t i = 0; i < 3; ++i) {
      const SampleCorner& a = corners[i];
      const SampleCorner& b = corners[(i + 1) % 3];
      if (std::min(a.y, b.y) > y + slack || std::max(a.y, b.y) < y - slack) continue;
      if (std::abs(a.y - b.y) <= slack) {
        left = std::min({left, a.x, b.x});
        right = std::max({right, a.x, b.x});
        continue;
      }
      const double part = std::clamp((y - a.y) / (b.y - a.y), 0.0, 1.0);
      const double x = a.x + part * (b.x - a.x);
      left = std::min(left, x);
      right = std::max(right, x);
    }
    if (left > right) return;
    const std::size_t last = last_at(right, grid_.points());
    for (std::size_t point = first_at(left, grid_.points()); point <= last; ++point)
      grid_.heights[slice * grid_.points() + point] = height_at(corners, place_of(point, grid_.points()), y);
  }

  static double height_at(const std::array<SampleCorner, 3>& corners, double x, double y) {
    const auto area = [](const SampleCorner& a, const SampleCorner& b, double px, double py) {
      return (b.x - a.x) * (py - a.y) - (b.y - a.y) * (px - a.x);
    };
    const double whole = area(corners[0], corners[1], corners[2].x, corners[2].y);
    double height = 0;
    double parts = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double part = std::max(0.0, area(corners[(i + 1) % 3], corners[(i + 2) % 3], x, y) / whole);
      height += part * corners[i].height;
      parts += part;
    }
    return height / parts;
  }

  HeightGrid& grid_;
};


}  // namespace

base::Result<HeightGrid> interpolated(const std::vector<ScatteredPoint>& points, GridSize size, std::string_view source) {
  const auto on_a_line = [&](const std::string& found) {
    return base::Error{std::string(source), "", found, "three points or more that are not on one line"};
  };
  if (points.size() < 3) return on_a_line(count_of(points.size(), "point"));
  const RoundingScale x{extent_of(points, &ScatteredPoint::x)};
  const RoundingScale y{extent_of(points, &ScatteredPoint::y)};
  const std::string line = count_of(points.size(), "point") + " on one line";
  for (const Interval& domain : {x.domain, y.domain})
    if (!(domain.high / 2 - domain.low / 2 >= std::numeric_limits<double>::min())) return on_a_line(line);
  std::vector<Point2> rounded;
  rounded.reserve(points.size());
  for (const ScatteredPoint& point : points) rounded.push_back({x.rounded(point.x), y.rounded(point.y)});
  const auto triangles = delaunay(rounded);
  if (triangles.empty()) return on_a_line(line);
  HeightGrid grid{even_positions(size.points), even_positions(size.slices), {}, x.domain, y.domain, {}, {}, {}};
  grid.heights.assign(size.points * size.slices, std::numeric_limits<double>::quiet_NaN());
  TriangleFiller filler(grid);
  for (const auto& triangle : triangles) {
    std::array<SampleCorner, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = {static_cast<double>(rounded[triangle[i]][0]), static_cast<double>(rounded[triangle[i]][1]),
                    points[triangle[i]].height};
    filler.fill(corners);
  }
  const auto holes =
      static_cast<std::size_t>(std::count_if(grid.heights.begin(), grid.heights.end(), [](double h) { return std::isnan(h); }));
  grid.note = count_of(points.size(), "point") + ", " + count_of(triangles.size(), "triangle") + ", a grid of " +
              std::to_string(size.points) + " x " + std::to_string(size.slices);
  if (holes > 0) grid.note += ", " + count_of(holes, "place") + " outside of the points";
  return grid;
}

}  // namespace sightline::scene
