// Lit points compared with lines in floating point: a truth that does not share the rounding of what is measured, so that
// rounding is part of the error.
//
// A dot is compared with the nearest place of any line, a place of a line with the nearest dot; lines are sampled every
// quarter of a point. A right picture of dots is within 0.5 points of its lines in the direction across, and dots of
// neighbouring columns of a line are up to 1.41 apart: so the distances of a perfect raster are not 0, but below 1.
#pragma once

#include <cstdint>
#include <vector>

#include "host/picture/line_metrics.hpp"
#include "host/picture/pixel_metrics.hpp"

namespace sightline::picture {

struct DotsAndLines {
  std::uint64_t dots = 0;
  std::uint64_t dots_beyond_1 = 0;  // farther than 1 point from every line: too many
  std::uint64_t dots_beyond_2 = 0;
  double length = 0;           // of the lines, points
  double length_beyond_1 = 0;  // of it, farther than 1 point from every dot: missing
  double length_beyond_2 = 0;
  HausdorffDistance hausdorff;  // of dots and lines, in points, as hausdorff_distance() has it
};

// What is not 0 is a dot: a segment of no length for each.
[[nodiscard]] std::vector<PixelSegment> dot_segments(const PixelGrid& dots);

[[nodiscard]] DotsAndLines dots_and_lines(const PixelGrid& dots, const std::vector<PixelSegment>& lines);

}  // namespace sightline::picture
