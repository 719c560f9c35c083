// The exactly visible parts of a scene's lines: the reference that programs and algorithms are measured
// against.
//
// A point of a line is visible iff the line is a feature on the side the eye is on (RealLine), and the sight
// line from the eye to the point passes no matter: no solid, no wall crossed. Where the sight line only
// touches matter, along a face or through a grid edge, it is stopped iff both ways of stepping aside are
// stopped; so nothing is seen through the joint of two walls or two solids, and the line along the edge of a
// door is seen beyond the door.
//
// Method: all sight lines to one line of direction a look like a single ray when seen along a. The ray is
// followed through the grid; each piece of matter it meets hides an interval of the line with rational ends,
// and what is left is the answer. Slow and simple: lines x (grid lines crossed) x (units along the line).
// Coordinates below 2^15 in magnitude give differences of 17 bits and fractions of at most 36 bits, compared
// in 128.
#pragma once

#include <optional>
#include <vector>

#include "host/algorithms/oracle/drawn_error.hpp"
#include "host/algorithms/oracle/matter.hpp"
#include "host/geometry/box.hpp"
#include "host/geometry/interval_set.hpp"
#include "host/scene/model/cell_scene.hpp"

namespace sightline::algorithms::oracle {

// What the screen shows, in points: X = x * scale / z + centre for x, y, z relative to the eye, which looks
// along +z.
struct Window {
  std::int32_t scale = 512;  // 1 .. 4096
  std::array<std::int32_t, 2> centre{512, 512};
  std::array<geometry::Span, 2> points{geometry::Span{0, 1023}, geometry::Span{0, 1023}};  // ends included
  std::int32_t near = 8;  // nothing nearer than this z is shown
};

struct VisibleLine {
  geometry::Point p{};
  geometry::Point q{};
  geometry::IntervalSet intervals;  // of t in [0, 1], the point being p + t (q - p)
};

// Whether the line is one for an eye there: matter is not flat on the side, or sides, that the eye is on.
[[nodiscard]] bool is_line_for(const RealLine& line, const geometry::Point& eye);

// Lines of which nothing is seen are left out, and so are those that run through the eye. The eye is inside
// the outer box and in no solid (precondition).
[[nodiscard]] std::vector<VisibleLine> visible_lines(const Matter& matter, const std::vector<RealLine>& lines,
                                                     const geometry::Point& eye, const Window& window);
// The same from a scene; empty if the scene is beyond Matter's limits.
[[nodiscard]] std::optional<std::vector<VisibleLine>> visible_lines(const scene::CellScene& scene,
                                                                    const geometry::Point& eye,
                                                                    const Window& window);

// The visible pieces as they appear on the screen, in points.
[[nodiscard]] std::vector<ScreenSegment> on_screen(const std::vector<VisibleLine>& lines,
                                                   const geometry::Point& eye, const Window& window);

}  // namespace sightline::algorithms::oracle
