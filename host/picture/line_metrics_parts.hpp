// Parts of a line with real ends, for measurements. Exact pictures use geometry::IntervalSet.
#pragma once

#include <vector>

#include "host/picture/line_metrics.hpp"

namespace sightline::picture {

using LineParts = std::vector<LinePart>;  // ascending, disjoint, each of a positive length

// The parts may be in any order and direction, and may overlap.
[[nodiscard]] LineParts united(LineParts parts);
[[nodiscard]] LineParts common(const LineParts& a, const LineParts& b);
// The parts of a that are not in b.
[[nodiscard]] LineParts without(const LineParts& a, const LineParts& b);
[[nodiscard]] double total(const LineParts& parts);
[[nodiscard]] bool contains(const LineParts& parts, double place);

[[nodiscard]] double length_of(const PixelSegment& segment);
[[nodiscard]] PixelPoint point_at(const PixelSegment& segment, double place);
[[nodiscard]] PixelSegment part_of(const PixelSegment& segment, const LinePart& part);
// The parameter of the foot of the perpendicular; 0 for a segment of length 0.
[[nodiscard]] double place_on(const PixelSegment& segment, const PixelPoint& point);
// The distance between a point and the nearest point of a segment.
[[nodiscard]] double distance(const PixelPoint& point, const PixelSegment& segment);

// The greatest distance, and the distance that all but one in a thousand do not exceed. 0 if there are none.
[[nodiscard]] HausdorffDistance directed_hausdorff_distance(std::vector<double> distances);
// Distances from `b` of points of `a`, a quarter of a pixel apart.
[[nodiscard]] HausdorffDistance directed_hausdorff_distance(const std::vector<PixelSegment>& a, const std::vector<PixelSegment>& b);

// A line with its visible and its drawn parts.
struct MeasuredLine {
  PixelSegment image;
  double length = 0;
  LineParts edges;
  LineParts visible;
  LineParts drawn;
};

// Lines ascend by number. A line unknown to the reference has no visible parts.
[[nodiscard]] std::vector<MeasuredLine> measured_lines(const std::vector<ReferenceLine>& reference,
                                                       const std::vector<DrawnPiece>& drawn);

}  // namespace sightline::picture
