// How much of a scene's lines a drawing shows wrongly, line by line: the symmetric difference of drawn and
// visible length. Unlike an error of point sets (oracle/drawn_error.hpp) it counts a piece of a hidden line
// as wrong even where it falls on another line that is visible.
//
// All pieces on one straight line of space are taken together, so that pieces drawn twice and pieces that
// continue each other count once. A piece is measured along the true image of its line, its ends projected on
// it at right angles. Lengths are points of the screen.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "host/algorithms/oracle/visible_lines.hpp"
#include "host/guests/jones/precision.hpp"

namespace sightline::guests::jones {

// A line of the scene as drawn.
struct DrawnLine {
  SceneLine line;
  algorithms::oracle::ScreenSegment piece;  // points of the screen
};

// A stretch that is drawn and not visible (extra), or visible and not drawn.
struct WrongStretch {
  SceneLine line;  // on the straight line where it lies: all that was drawn or visible there, from end to end
  bool extra = false;
  double length = 0;
  algorithms::oracle::ScreenSegment where;  // on the true image of the line
};

struct LineError {
  double visible = 0;  // true visible length
  double missing = 0;
  double extra = 0;
  double longest = 0;               // wrong stretch
  std::vector<WrongStretch> wrong;  // longer than asked for, by line
  [[nodiscard]] double share() const { return visible > 0 ? (missing + extra) / visible : 0; }
};

// truth: exactly what is seen from the eye in this window (mono, centre of the window as in `window`).
// named_from: wrong stretches longer than this are listed.
[[nodiscard]] LineError line_error(const std::vector<algorithms::oracle::VisibleLine>& truth,
                                   const std::vector<DrawnLine>& drawn, const geometry::Point& eye,
                                   const algorithms::oracle::Window& window, double named_from);

}  // namespace sightline::guests::jones
