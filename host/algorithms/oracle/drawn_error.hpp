// The error of a drawing: the lengths of missing and of extra lines on the screen.
//
// Both drawings are compared as sets of points. A part of one counts as found if some point of the other is within a
// given distance; position errors below that distance are therefore ignored, and drawing a line twice is no error.
// Lengths are measured at the midpoints of equal steps of at most 0.25 points.
#pragma once

#include <vector>

namespace sightline::algorithms::oracle {

// In points of the screen. The order of the ends does not matter.
struct ScreenSegment {
  double x0 = 0;
  double y0 = 0;
  double x1 = 0;
  double y1 = 0;
};

struct DrawnError {
  double true_length = 0;   // of all true segments
  double drawn_length = 0;  // of all drawn segments
  double missing = 0;       // of true_length, farther than the distance from everything drawn
  double extra = 0;         // of drawn_length, farther than the distance from everything true
};

[[nodiscard]] DrawnError drawn_error(const std::vector<ScreenSegment>& reference,
                                     const std::vector<ScreenSegment>& drawn, double distance);

}  // namespace sightline::algorithms::oracle
