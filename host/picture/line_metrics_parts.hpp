// Parts of a line with real ends, as measurements have them; exact pictures use geometry::IntervalSet.
#pragma once

#include <vector>

#include "host/picture/line_metrics.hpp"

namespace sightline::picture {

using LineParts = std::vector<LinePart>;  // ascending, disjoint, each of a positive length

// Any parts, in any order and direction.
[[nodiscard]] LineParts united(LineParts parts);
[[nodiscard]] LineParts common(const LineParts& a, const LineParts& b);
// What a has and b has not.
[[nodiscard]] LineParts without(const LineParts& a, const LineParts& b);
[[nodiscard]] double total(const LineParts& parts);
[[nodiscard]] bool contains(const LineParts& parts, double place);

[[nodiscard]] double length_of(const PixelSegment& segment);
[[nodiscard]] PixelPoint point_at(const PixelSegment& segment, double place);
[[nodiscard]] PixelSegment part_of(const PixelSegment& segment, const LinePart& part);
// Of the foot of the perpendicular; 0 on a segment of no length.
[[nodiscard]] double place_on(const PixelSegment& segment, const PixelPoint& point);
// Between a point and the nearest point of a segment.
[[nodiscard]] double distance(const PixelPoint& point, const PixelSegment& segment);

// Of distances from another picture: the greatest, and what all but one in a thousand do not exceed. Of none: 0.
[[nodiscard]] HausdorffDistance one_way(std::vector<double> distances);
// Of the places of `a`, a quarter of a pixel apart, from `b`.
[[nodiscard]] HausdorffDistance one_way(const std::vector<PixelSegment>& a, const std::vector<PixelSegment>& b);

// A line with what is seen of it and what is drawn of it.
struct MeasuredLine {
  PixelSegment image;
  double length = 0;
  LineParts edges;
  LineParts visible;
  LineParts drawn;
};

// Lines in the order of their numbers; pieces of unknown lines are lines of which nothing is seen.
[[nodiscard]] std::vector<MeasuredLine> measured_lines(const std::vector<ReferenceLine>& truth,
                                                       const std::vector<DrawnPiece>& drawn);

}  // namespace sightline::picture
