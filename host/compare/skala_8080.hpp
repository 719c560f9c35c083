// Pictures of Skala's program on the 8080, of every kind and on every device, as ink in dots; and what of the surface it should
// show, not rounded to dots.
//
// A dot is a point of the 256 by 256; ink is the dots of a raster board (the memory of both boards holds the same, the ALT-256
// shows all rows but the uppermost), and the way of a plotter's pen.
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
  std::vector<picture::PixelSegment> ink;  // a dot is a segment of no length
  std::string difference;  // from its twin; empty: the same in every dot or movement, mask and status
};

// "lines, CalComp 565"
[[nodiscard]] std::string name_of(const SkalaInk& ink);
// Surfaces have no lines of their own on a raster board; a plotter draws them as lines.
[[nodiscard]] bool shows_lines(const SkalaInk& ink);

// Every picture on every device; a surface is shaded on the raster boards, and its lines again on the plotters. Contours are
// without silhouette. The grid is a whole one of at least two by two, the view without zoom.
[[nodiscard]] std::vector<SkalaInk> skala_pictures(const scene::HeightGrid& grid, const algorithms::skala::View& view);

// The unrounded lines of such a picture: of lines what is seen of them; of contours all of them, hidden or not, and the outline
// of the whole surface. `kind`: lines or contours.
[[nodiscard]] std::vector<picture::PixelSegment> unrounded_ink(const scene::HeightGrid& grid, algorithms::skala::View view,
                                                               algorithms::skala::Subject kind);

// How far, in dots, ink may be from the unrounded lines or the surface, and these from ink.
//
// An end is rounded by half a dot in both coordinates; a dot of the line between the rounded ends is off it by half a dot in the
// one, and half a step away in the other. So a dot is at most (1, 1/2) from its unrounded line, and a place of the line at most
// (1, 3/2) from its dot. A dot above all masks may belong to a place that something hides which is nearer by less than a dot:
// that is then within (1, 1). A place that is seen may have no dot because the mask of its column reaches as far: the top of the
// mask has ink, and is at most (3/2, 3) away, if the occluder rises by no more than 45 degrees there. A plotter's run of a single
// dot is dropped: one step (1, 1) more.
//
// Contours hide nothing, and the margins that hide them have no ink; the program shows them as far as a dot below the mask. So
// one that runs along the edge of its occluder may be shown or lost over any length: only where their dots are is bounded, and
// which of them are shown is compared with the column oracle, dot by dot.
//
// The outline of contours and the border of a shaded surface join the tops of masks: a dot between those of two columns is at
// most 2 from a place that the unrounded outline has between them. Inside a surface everything has ink.
struct InkBounds {
  double of_ink = 0;
  std::optional<double> of_lines;
};
[[nodiscard]] InkBounds ink_bounds(const SkalaInk& ink);

}  // namespace sightline::compare
