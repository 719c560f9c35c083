#include "host/picture/dots_and_lines.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "host/picture/line_metrics_near.hpp"
#include "host/picture/line_metrics_parts.hpp"

namespace sightline::picture {
namespace {

constexpr double step = 0.25;  // points between samples of a line

}  // namespace

std::vector<PixelSegment> dot_segments(const PixelGrid& dots) {
  std::vector<PixelSegment> points;
  for (int y = 0; y < dots.height; ++y) {
    for (int x = 0; x < dots.width; ++x) {
      if (dots.at(x, y) == 0) continue;
      const PixelPoint point{static_cast<double>(x), static_cast<double>(y)};
      points.push_back({point, point});
    }
  }
  return points;
}

DotsAndLines dots_and_lines(const PixelGrid& dots, const std::vector<PixelSegment>& lines) {
  DotsAndLines compared;
  const std::vector<PixelSegment> points = dot_segments(dots);
  compared.dots = points.size();

  const NearestSegment near_lines(lines);
  std::vector<double> of_dots;
  std::uint32_t near = 0;
  for (const PixelSegment& dot : points) {
    of_dots.push_back(near_lines.distance(dot.a, near));
    compared.dots_beyond_1 += of_dots.back() > 1 ? 1U : 0U;
    compared.dots_beyond_2 += of_dots.back() > 2 ? 1U : 0U;
  }

  const NearestSegment near_dots(points);
  std::vector<double> of_lines;
  near = 0;
  for (const PixelSegment& line : lines) {
    const double length = length_of(line);
    const double steps = std::max(1.0, std::ceil(length / step));
    compared.length += length;
    // Each step is represented by its middle; the ends are used only for the distance.
    for (double n = 0; n <= 2 * steps; ++n) {
      const bool middle = std::fmod(n, 2) == 1;
      if (!middle && n != 0 && n != 2 * steps) continue;
      const double distance = near_dots.distance(point_at(line, n / (2 * steps)), near);
      of_lines.push_back(distance);
      if (!middle) continue;
      compared.length_beyond_1 += distance > 1 ? length / steps : 0;
      compared.length_beyond_2 += distance > 2 ? length / steps : 0;
    }
  }
  const HausdorffDistance there = directed_hausdorff_distance(std::move(of_lines));
  const HausdorffDistance back = directed_hausdorff_distance(std::move(of_dots));
  compared.hausdorff = {std::max(there.greatest, back.greatest), std::max(there.usual, back.usual)};
  return compared;
}

}  // namespace sightline::picture
