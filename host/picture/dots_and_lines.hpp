// Compares lit points with lines in floating point. The lines are a reference that does not share the rounding of the
// dots, so rounding counts as error.
//
// The distance of a dot is that to the nearest point of any line; the distance of a point of a line is that to the
// nearest dot. Lines are sampled every quarter of a point. In a correct picture, dots are within 0.5 points of their
// lines across, and dots in adjacent columns of a line are up to 1.41 apart. So the distances of a perfect raster are not
// 0, but below 1.
#pragma once

#include <cstdint>
#include <vector>

#include "host/picture/line_metrics.hpp"
#include "host/picture/pixel_metrics.hpp"

namespace sightline::picture {

struct DotsAndLines {
  std::uint64_t dots = 0;
  std::uint64_t dots_beyond_1 = 0;  // farther than 1 point from every line: extra
  std::uint64_t dots_beyond_2 = 0;
  double length = 0;           // of the lines, points
  double length_beyond_1 = 0;  // farther than 1 point from every dot: missing
  double length_beyond_2 = 0;
  HausdorffDistance hausdorff;  // between dots and lines, in points, as in hausdorff_distance()
};

// One segment of length 0 for each pixel that is not 0.
[[nodiscard]] std::vector<PixelSegment> dot_segments(const PixelGrid& dots);

[[nodiscard]] DotsAndLines dots_and_lines(const PixelGrid& dots, const std::vector<PixelSegment>& lines);

}  // namespace sightline::picture
