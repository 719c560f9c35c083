// Compares one view of a function of two variables, drawn by every method of the registry on the 256 by 256 points of
// Skala's raster board, with the column oracle: Skala's program on its 8080, its twin, and the native algorithm,
// whose vectors are put on the same points.
//
// A point counts as lit or not; colours and greys are not compared. Pictures of vectors are also measured as such:
// lines and contours against the visible parts of the surface's own lines, surfaces by the visible cell at each point
// (height_truth.hpp).
//
// The column oracle rounds lines to dots as the programs do, so a correct program does not differ from it. Dots are
// therefore also compared with the unrounded lines between the samples, and the program's dots with the native
// drawing's by the program's own rule (device_raster.hpp). The distance between the function and the lines between
// its samples is no method's error and is reported separately (chord_error.hpp).
//
// Left out: silhouettes of contour pictures, whose reach depends on more than depth; grids with undefined heights and
// zoomed views, which the oracle does not support.
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
  std::optional<picture::PixelGrid> truth{};  // if it is not that of the comparison
  std::string against = "the column oracle";
  std::string rounding{};  // what is rounded, and to what
  // For lines and contours: the visible parts of the unrounded lines compared with these dots, without the outline of
  // contours.
  std::optional<picture::DotsAndLines> unrounded{};
  // For a program: the native drawing by the program's rule compared with these dots, without the outline of
  // contours.
  std::optional<picture::RasterDifference> from_native{};
};

struct ComparedVectors {
  std::string name;  // "native lines"
  picture::LineMetrics metrics;
  picture::LineDifference difference;  // stretches of up to a point of the screen are ignored
};

struct HeightComparison {
  algorithms::skala::View view;
  picture::PixelGrid truth;
  std::vector<ComparedRaster> rasters;
  std::vector<ComparedVectors> vectors;
  picture::PixelGrid native_dots;   // of the native drawing, by the rule of Skala's program; for a surface, its painted area
  std::optional<ChordError> chord;  // for lines; empty if there is nothing between the samples
  std::string guest_difference;  // from its twin; empty if identical in every dot, mask and status
  core::TStates guest_time{};
  std::optional<double> native_seconds{};  // of the native drawing on this computer, if requested: the median of repeated runs
  std::vector<ComparedDevice> devices{};  // from compare_devices(); compare_heights() leaves it empty

  [[nodiscard]] bool agrees() const {
    return guest_difference.empty() && std::all_of(devices.begin(), devices.end(),
                                                   [](const ComparedDevice& d) { return d.difference.empty(); });
  }
};

// Empty if the view can be compared.
[[nodiscard]] std::optional<std::string> why_not_comparable(const scene::HeightGrid& grid,
                                                            const algorithms::skala::View& view);

// Uses the EF9365 board, whatever the view says. The grid and the view can be compared (precondition). `sampler`
// samples the grid's function.
[[nodiscard]] HeightComparison compare_heights(
    const scene::HeightGrid& grid, const algorithms::skala::View& view,
    const std::function<void(std::string_view)>& progress = [](std::string_view) {},
    const HeightSampler& sampler = {}, bool host_times = false);

}  // namespace sightline::compare
