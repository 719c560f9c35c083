// What a drawing of a scene of cells shows wrongly: stretches of the true lines that are farther than a
// distance from everything drawn, and stretches drawn that are farther than it from everything true.
//
// Both pictures are sets of points of the screen: lines that lie on each other in the image count once. Ends
// of stretches are calculated, not sampled: what is within a distance of a segment is convex, so of another
// segment it is one interval.
#pragma once

#include <vector>

#include "host/algorithms/oracle/drawn_error.hpp"
#include "host/algorithms/oracle/visible_lines.hpp"
#include "host/compare/lines.hpp"
#include "host/geometry/box.hpp"

namespace sightline::compare {

// A piece of the screen, in points, and the line of space of which it is the image.
struct ImagePiece {
  AxisLine line;
  algorithms::oracle::ScreenSegment at;
};

[[nodiscard]] std::vector<ImagePiece> image_pieces(
    const std::vector<algorithms::oracle::VisibleLine>& visible, const geometry::Point& eye,
    const algorithms::oracle::Window& window);

struct ScreenStretch {
  AxisLine line;       // of lines that lie on each other in the image, the first in their order
  bool extra = false;  // drawn, and nothing true is near it; otherwise true and missing
  double length = 0;   // points of the screen
  algorithms::oracle::ScreenSegment at;  // on the true image of the line
};

struct WrongStretches {
  double true_length = 0;  // points of the screen
  double missing = 0;
  double extra = 0;
  std::vector<ScreenStretch> stretches;
  [[nodiscard]] double length() const { return missing + extra; }
};

// Stretches shorter than this are left out.
inline constexpr double least_wrong_stretch = 0.25;

// distance: points of the screen, above 0. Pieces of lines through the eye are left out.
[[nodiscard]] WrongStretches wrong_stretches(const std::vector<ImagePiece>& truth,
                                             const std::vector<ImagePiece>& drawn, double distance,
                                             const geometry::Point& eye,
                                             const algorithms::oracle::Window& window);

}  // namespace sightline::compare
