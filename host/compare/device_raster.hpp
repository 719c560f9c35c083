// The points that a device lights, as sets for comparison (host/picture/raster_difference.hpp): the points of a run,
// and the points that the exact lines would light if the program drew them on that device.
//
// The exact lines are rounded by the program's rule. So a difference shows an error of visibility, or of a line's
// calculated position:
//   Type 340   ends to the nearest point, halves up. A line longer than 127 points is several vector words, divided
//              as the program does. The points are those of the rate multiplier, up to 1.6 points off the line.
//   Skala      ends to the nearest dot, halves up, a dot per step of the modified Bresenham algorithm. A dot is lit
//              where the unrounded line is visible at its column (its row, for a steep line). A plotter drops runs
//              of one dot.
//   stripes    the sides of dots between which different faces are visible, as the pen draws them, but for corners:
//              two sides in one step leave their corner out. On the raster board a dot shows its face; the faces of
//              a picture (host/compare/faces.hpp) are its lit points.
//
// On the Type 340, a line in two pieces lights other points than in one, and programs divide lines at cells.
// divide_like() divides the exact lines at the same places.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "emulators/core/raster.hpp"
#include "emulators/core/stroke.hpp"
#include "host/picture/line_metrics.hpp"
#include "host/picture/pen_path.hpp"
#include "host/picture/pixel_metrics.hpp"
#include "host/picture/raster_difference.hpp"
#include "host/picture/stroke_recorders.hpp"

namespace sightline::compare {

// The points that a run has lit (1). Places outside the square are left out.

// Flashes of a display, or marks of a plotter's pen.
[[nodiscard]] picture::PixelGrid points_of(std::span<const core::Stroke> strokes, int side = picture::screen_points);
[[nodiscard]] picture::PixelGrid points_of(const core::Raster& raster);
// The steps of a lowered pen, and the points where it was lowered.
[[nodiscard]] picture::PixelGrid points_of(std::span<const picture::PenPath> paths, int side = 256);

// How a program divides a line longer than a vector word: Jones's program in words of equal length, rounded; the
// program of turning solids in words of 127 and a rest.
enum class LongLines : std::uint8_t { jones, turn };

// On the 1024 by 1024 points of the Type 340. Ends outside are moved to its border. A line of length 0 lights nothing
// with Jones's program, and its point with the other.
[[nodiscard]] picture::PixelGrid type340_points(std::span<const picture::PixelSegment> lines,
                                                LongLines program = LongLines::jones);

// Divides the lines where pieces of a program's drawing that lie on them, within `near` points, begin and end.
[[nodiscard]] std::vector<picture::PixelSegment> divide_like(std::span<const picture::PixelSegment> lines,
                                                            std::span<const picture::PixelSegment> pieces, double near = 1);

struct ComparedFlashes {
  picture::PixelGrid truth;
  picture::PixelGrid shown;
  picture::RasterDifference difference;
};
// Compares the flashes of one pass of Jones's program with the exact lines by its rule, divided at the ends of the
// program's pieces (before or after rounding). All in points of the display.
[[nodiscard]] ComparedFlashes compare_flashes(std::span<const picture::PixelSegment> exact,
                                              std::span<const picture::PixelSegment> pieces,
                                              std::span<const core::Stroke> pass);

// The visible parts of the lines.
[[nodiscard]] std::vector<picture::PixelSegment> visible_segments(std::span<const picture::ReferenceLine> lines);
// The same lines with the drawn pieces as their visible parts. Pieces of other lines are left out.
[[nodiscard]] std::vector<picture::ReferenceLine> lines_as_drawn(std::vector<picture::ReferenceLine> lines,
                                                                 std::span<const picture::DrawnPiece> pieces);

// The dots of the lines' visible parts in Skala's picture of 256 by 256 dots.
enum class SkalaDevice : std::uint8_t { raster, plotter };
[[nodiscard]] picture::PixelGrid skala_points(std::span<const picture::ReferenceLine> lines,
                                              SkalaDevice device = SkalaDevice::raster);

// The ends of the sides of dots that separate different numbers; the border of the picture is no side. Point (x, y)
// is the lower left corner of dot (x, y), so the grid is larger by 1 in both directions.
[[nodiscard]] picture::PixelGrid stripes_pen_points(const picture::PixelGrid& faces);

}  // namespace sightline::compare
