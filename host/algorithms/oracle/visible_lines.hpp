// Computes exactly the visible parts of a scene's lines: the reference for programs and algorithms.
//
// A point of a line is visible iff the line is a feature on the side of the eye (RealLine) and the sight line from the
// eye to the point meets no matter: it enters no solid and crosses no wall. If the sight line only touches matter, along
// a face or through a grid edge, it is stopped iff it would be stopped when moved to either side. So nothing is seen
// through the joint of two walls or two solids, and the line along the edge of a door is seen beyond the door.
//
// Method: seen along direction a, all sight lines to one line of that direction are a single ray. The ray is followed
// through the grid; each piece of matter that it meets hides an interval of the line with rational ends, and the rest is
// visible. Slow and simple: lines x (grid lines crossed) x (units along the line). Coordinates below 2^15 in magnitude
// give differences of 17 bits and fractions of at most 36 bits, compared in 128 bits.
#pragma once

#include <optional>
#include <vector>

#include "host/algorithms/oracle/drawn_error.hpp"
#include "host/algorithms/oracle/matter.hpp"
#include "host/geometry/box.hpp"
#include "host/geometry/interval_set.hpp"
#include "host/scene/model/cell_scene.hpp"

namespace sightline::algorithms::oracle {

// The part of the plane that the screen shows, in points: X = x * scale / z + centre for x, y, z relative to the eye,
// which looks along +z.
struct Window {
  std::int32_t scale = 512;  // 1 .. 4096
  std::array<std::int32_t, 2> centre{512, 512};
  std::array<geometry::Span, 2> points{geometry::Span{0, 1023}, geometry::Span{0, 1023}};  // inclusive
  std::int32_t near = 8;  // least z shown
};

struct VisibleLine {
  geometry::Point p{};
  geometry::Point q{};
  geometry::IntervalSet intervals;  // t in [0, 1] for the point p + t (q - p)
};

// Whether the line is drawn for this eye: matter is not flat on the side, or sides, of the eye.
[[nodiscard]] bool is_line_for(const RealLine& line, const geometry::Point& eye);

// Omits lines that are not visible at all or pass through the eye. Precondition: the eye is inside the outer box and in
// no solid.
[[nodiscard]] std::vector<VisibleLine> visible_lines(const Matter& matter, const std::vector<RealLine>& lines,
                                                     const geometry::Point& eye, const Window& window);
// The same from a scene; nullopt if the scene exceeds the limits of Matter.
[[nodiscard]] std::optional<std::vector<VisibleLine>> visible_lines(const scene::CellScene& scene,
                                                                    const geometry::Point& eye,
                                                                    const Window& window);

// The visible pieces on the screen, in points.
[[nodiscard]] std::vector<ScreenSegment> on_screen(const std::vector<VisibleLine>& lines,
                                                   const geometry::Point& eye, const Window& window);
// The visible pieces of a view turned about the vertical, which looks along (sine, 0, cosine), a vector of any length. There is no near
// plane: window.near does not count. Only the visibility is exact: the image is in floating point.
[[nodiscard]] std::vector<ScreenSegment> turned_view(const Matter& matter, const std::vector<RealLine>& lines, const geometry::Point& eye,
                                                     const Window& window, double cosine, double sine);

}  // namespace sightline::algorithms::oracle
