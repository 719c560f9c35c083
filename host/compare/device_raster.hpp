// The points that a device lights, as sets to be compared (host/picture/raster_difference.hpp): those a run has shown,
// and those exact lines would light if that program drew them on that device.
//
// Rounding is the program's, so that what differs is what the program saw otherwise, or where the words it calculates
// with put a line:
//   Type 340   ends to the nearest point, halves up; a line longer than 127 points is several vector words, divided as
//              the program does it; the points are those of the rate multiplier, which wanders up to 1.6 points off.
//   Skala      ends to the nearest dot, halves up, a dot a step by the modified Bresenham algorithm; a dot is lit where
//              the unrounded line is seen at its column (its row, of a steep line). On a plotter a run of one dot is
//              dropped.
//   stripes    the sides of dots between which different faces are seen, as the pen draws them, but for corners: two
//              sides in one step leave their corner out. On the raster board a dot is its face's; the faces of a
//              picture (host/compare/faces.hpp) are its lit points as they are.
// A line drawn in two pieces lights other points on the Type 340 than in one, and programs divide lines where cells do:
// divided_as() divides exact ones there.
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

// What a run has shown, 1 where lit. Places outside of the square are left out.

// Flashes of a display, or marks of a plotter's pen.
[[nodiscard]] picture::PixelGrid points_of(std::span<const core::Stroke> strokes, int side = picture::screen_points);
[[nodiscard]] picture::PixelGrid points_of(const core::Raster& raster);
// The steps of a pen that is down, and where it was lowered.
[[nodiscard]] picture::PixelGrid points_of(std::span<const picture::PenPath> paths, int side = 256);

// How a program divides a line longer than a vector word: Jones's in words of equal length, rounded; the one of turning
// solids in words of 127 and a rest.
enum class LongLines : std::uint8_t { jones, turn };

// On the 1024 by 1024 points of the Type 340; ends outside are moved to its border. A line of no length lights nothing
// with Jones's program, its point with the other.
[[nodiscard]] picture::PixelGrid type340_points(std::span<const picture::PixelSegment> lines,
                                                LongLines program = LongLines::jones);

// The lines, each divided where pieces of a program's drawing that lie on it, by `near` points at most, begin and end.
[[nodiscard]] std::vector<picture::PixelSegment> divided_as(std::span<const picture::PixelSegment> lines,
                                                            std::span<const picture::PixelSegment> pieces, double near = 1);

struct ComparedFlashes {
  picture::PixelGrid truth;
  picture::PixelGrid shown;
  picture::RasterDifference difference;
};
// The flashes of one pass of Jones's program against exact lines by its rule, divided where the program's pieces (before or after
// their rounding) are; all in points of the display.
[[nodiscard]] ComparedFlashes compare_flashes(std::span<const picture::PixelSegment> exact,
                                              std::span<const picture::PixelSegment> pieces,
                                              std::span<const core::Stroke> pass);

// What is seen of the lines.
[[nodiscard]] std::vector<picture::PixelSegment> visible_segments(std::span<const picture::ReferenceLine> lines);
// The same lines with what of them is drawn in the place of what is seen. Pieces of other lines are left out.
[[nodiscard]] std::vector<picture::ReferenceLine> lines_as_drawn(std::vector<picture::ReferenceLine> lines,
                                                                 std::span<const picture::DrawnPiece> pieces);

// Of what is seen of lines in Skala's picture of 256 by 256 dots.
enum class SkalaDevice : std::uint8_t { raster, plotter };
[[nodiscard]] picture::PixelGrid skala_points(std::span<const picture::ReferenceLine> lines,
                                              SkalaDevice device = SkalaDevice::raster);

// The ends of the sides of dots that separate different numbers; the border of the picture is no side. Point (x, y) is the lower left
// corner of dot (x, y): a grid larger by 1 in both directions.
[[nodiscard]] picture::PixelGrid stripes_pen_points(const picture::PixelGrid& faces);

}  // namespace sightline::compare
