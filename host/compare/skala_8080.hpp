// Pictures of Skala's program on the 8080, of every kind and on every device, as ink in dots; and the parts of the
// surface that each should show, not rounded to dots.
//
// A dot is one of the 256 by 256 points. Ink is the dots of a raster board (both boards' memories hold the same; the
// ALT-256 shows all rows but the uppermost), or the path of a plotter's pen.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/algorithms/skala/view.hpp"
#include "host/programs/skala/commands.hpp"
#include "host/picture/line_metrics.hpp"
#include "host/picture/pixel_metrics.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::compare {

inline constexpr std::string_view skala_8080_name = "skala-8080";

struct SkalaInk {
  algorithms::skala::Subject kind{};
  programs::skala::Device device{};
  picture::PixelGrid dots;                 // 1 where there is ink
  std::vector<picture::PixelSegment> ink;  // a dot is a segment of length 0
  std::string difference;  // from its twin; empty if every dot or movement, mask and status is the same
};

// "lines, CalComp 565"
[[nodiscard]] std::string name_of(const SkalaInk& ink);
// Surfaces have no lines on a raster board; a plotter draws them as lines.
[[nodiscard]] bool shows_lines(const SkalaInk& ink);

// Every picture on every device. A surface is shaded on the raster boards and drawn as lines on the plotters.
// Contours are without silhouette. The grid has no holes and at least two by two points, the view no zoom
// (preconditions).
[[nodiscard]] std::vector<SkalaInk> skala_pictures(const scene::HeightGrid& grid, const algorithms::skala::View& view);

// The unrounded lines of such a picture: for lines, the visible parts; for contours all of them, hidden or not, and
// the outline of the whole surface. `kind`: lines or contours.
[[nodiscard]] std::vector<picture::PixelSegment> unrounded_ink(const scene::HeightGrid& grid, algorithms::skala::View view,
                                                               algorithms::skala::Subject kind);

// Bounds, in dots, of the distance of ink from the unrounded lines or the surface, and of these from ink.
//
// An end is rounded by half a dot in both coordinates. A dot of the line between the rounded ends is off it by half a
// dot in one coordinate, and half a step in the other. So a dot is at most (1, 1/2) from its unrounded line, and a
// point of the line at most (1, 3/2) from its dot. A dot above all masks may belong to a point that is hidden by an
// occluder less than a dot away, within (1, 1). A visible point may have no dot because the mask of its column
// reaches as far; the top of the mask has ink and is at most (3/2, 3) away, if the occluder rises by no more than 45
// degrees there. A plotter drops runs of a single dot: one more step (1, 1).
//
// Contours hide nothing, and the margins that hide them have no ink. The program shows contours down to a dot below
// the mask, so one along the edge of its occluder may be shown or lost over any length. Only the positions of their
// dots are bounded; which of them are shown is compared with the column oracle, dot by dot.
//
// The outline of contours and the border of a shaded surface join the tops of masks: a dot between the tops of two
// columns is at most 2 from the unrounded outline between them. Inside a surface everything has ink.
struct InkBounds {
  double of_ink = 0;
  std::optional<double> of_lines;
};
[[nodiscard]] InkBounds ink_bounds(const SkalaInk& ink);

}  // namespace sightline::compare
