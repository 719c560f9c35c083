// One view of a function of two variables by every method of the registry, on the 256 by 256 points of
// Skala's raster board, each compared with the column oracle: Skala's program on its 8080, its native twin,
// and the native algorithm, whose vectors are put on the same points.
//
// A point counts as lit or not; colours and greys are not compared. Of a picture of
// vectors, lines and contours are also measured as such, against what is truly seen of the surface's own
// lines, and its surface by which cell is seen at each point (height_truth.hpp).
//
// The column oracle rounds lines to dots as the programs do, so a program that does what it should differs from it by
// nothing. Dots are therefore also compared with the unrounded lines between the samples, and the program's with the
// native drawing on the same dots by the program's own rule (device_raster.hpp). How far the function is from its samples'
// lines is no method's error and stands apart (chord_error.hpp).
//
// Left out: silhouettes of contour pictures, whose reach depends on more than depth; grids with undefined
// heights and zoomed views, for which the oracle has no answer.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "emulators/core/tstates.hpp"
#include "host/compare/chord_error.hpp"
#include "host/compare/height_devices.hpp"
#include "host/algorithms/skala/view.hpp"
#include "host/picture/dots_and_lines.hpp"
#include "host/picture/line_metrics.hpp"
#include "host/picture/pixel_metrics.hpp"
#include "host/picture/raster_difference.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::compare {

struct ComparedRaster {
  std::string name;  // "guest", "twin", "native", "native cells"
  picture::PixelMetrics metrics;
  picture::PixelGrid grid;
  std::optional<picture::PixelGrid> truth{};  // where it is not that of the comparison
  std::string against = "the column oracle";
  std::string rounding{};  // of what, to what
  // Lines and contours: what is seen of the unrounded lines, and these dots; the outline of contours is left out.
  std::optional<picture::DotsAndLines> unrounded{};
  // A program's: the native drawing by the program's rule, and these dots; the outline of contours is left out.
  std::optional<picture::RasterDifference> from_native{};
};

struct ComparedVectors {
  std::string name;  // "native lines"
  picture::LineMetrics metrics;
  picture::LineDifference difference;  // without stretches of up to a point of the screen
};

struct HeightComparison {
  algorithms::skala::View view;
  picture::PixelGrid truth;
  std::vector<ComparedRaster> rasters;
  std::vector<ComparedVectors> vectors;
  picture::PixelGrid native_dots;   // of the native drawing, by the rule of Skala's program; of a surface, where it is painted
  std::optional<ChordError> chord;  // of lines; nothing: there is nothing between the samples
  std::string guest_difference;  // from its twin; empty: identical in every dot, mask and status
  core::TStates guest_time{};
  std::optional<double> native_seconds{};  // of the native drawing here, if asked for: the median of repeated ones
  std::vector<ComparedDevice> devices{};  // of compare_devices(); compare_heights() leaves them out

  [[nodiscard]] bool agrees() const {
    return guest_difference.empty() && std::all_of(devices.begin(), devices.end(),
                                                   [](const ComparedDevice& d) { return d.difference.empty(); });
  }
};

// Empty if it can be compared.
[[nodiscard]] std::optional<std::string> why_not_comparable(const scene::HeightGrid& grid,
                                                            const algorithms::skala::View& view);

// On the EF9365 board, whatever the view asks for. The grid and the view can be compared (precondition). The sampler is of
// the grid's function.
[[nodiscard]] HeightComparison compare_heights(
    const scene::HeightGrid& grid, const algorithms::skala::View& view,
    const std::function<void(std::string_view)>& progress = [](std::string_view) {},
    const HeightSampler& sampler = {}, bool host_times = false);

}  // namespace sightline::compare
