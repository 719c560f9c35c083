// Finds what a drawing of a scene of cells shows wrongly: stretches of the exact lines farther than a given distance
// from everything drawn, and drawn stretches farther than it from every exact line.
//
// Both pictures are sets of points of the screen: coinciding lines count once. Ends of stretches are calculated, not
// sampled: the points within a distance of a segment are a convex set, which cuts another segment in one interval.
#pragma once

#include <vector>

#include "host/algorithms/oracle/drawn_error.hpp"
#include "host/algorithms/oracle/visible_lines.hpp"
#include "host/compare/lines.hpp"
#include "host/geometry/box.hpp"

namespace sightline::compare {

// A piece of the screen, in points, and its line in space.
struct ImagePiece {
  AxisLine line;
  algorithms::oracle::ScreenSegment at;
};

[[nodiscard]] std::vector<ImagePiece> image_pieces(
    const std::vector<algorithms::oracle::VisibleLine>& visible, const geometry::Point& eye,
    const algorithms::oracle::Window& window);

struct ScreenStretch {
  AxisLine line;       // the first of lines that coincide in the image
  bool extra = false;  // drawn, with nothing exact near it; otherwise missing
  double length = 0;   // points of the screen
  algorithms::oracle::ScreenSegment at;  // on the exact image of the line
};

struct WrongStretches {
  double true_length = 0;  // points of the screen
  double missing = 0;
  double extra = 0;
  std::vector<ScreenStretch> stretches;
  [[nodiscard]] double length() const { return missing + extra; }
};

// Shorter stretches are left out.
inline constexpr double least_wrong_stretch = 0.25;

// distance: points of the screen, above 0. Pieces of lines through the eye are left out.
[[nodiscard]] WrongStretches wrong_stretches(const std::vector<ImagePiece>& truth,
                                             const std::vector<ImagePiece>& drawn, double distance,
                                             const geometry::Point& eye,
                                             const algorithms::oracle::Window& window);

}  // namespace sightline::compare
