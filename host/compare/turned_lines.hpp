// The exactly visible lines of a scene of cells on the screen of a view turned about the vertical. Only the visibility is exact:
// the image is in floating point.
#pragma once

#include <vector>

#include "host/algorithms/oracle/visible_lines.hpp"
#include "host/picture/line_metrics_parts.hpp"
#include "host/programs/jones/twin/rotation.hpp"

namespace sightline::compare {

// lines: as seen in every direction. The direction is taken as exact; its length is not exactly 1.
[[nodiscard]] std::vector<picture::PixelSegment> turned_lines(const std::vector<algorithms::oracle::VisibleLine>& lines, const geometry::Point& eye,
                                                              const programs::jones::Direction& direction, const algorithms::oracle::Window& window);

}  // namespace sightline::compare
