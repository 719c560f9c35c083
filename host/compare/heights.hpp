// One view of a function of two variables by every method of the registry, on the 256 by 256 points of
// Skala's raster board, each compared with the column oracle: Skala's program on its 8080, its native twin,
// and the native algorithm, whose vectors are put on the same points.
//
// A point counts as lit or not; colours and greys are not compared. Of a picture of
// vectors, lines and contours are also measured as such, against what is truly seen of the surface's own
// lines, and its surface by which cell is seen at each point (height_truth.hpp).
//
// Left out: silhouettes of contour pictures, whose reach depends on more than depth; grids with undefined
// heights and zoomed views, for which the oracle has no answer.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "emulators/core/tstates.hpp"
#include "host/guests/skala/view.hpp"
#include "host/picture/line_metrics.hpp"
#include "host/picture/pixel_metrics.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::compare {

struct ComparedRaster {
  std::string name;  // "guest", "twin", "native", "native cells"
  picture::PixelMetrics metrics;
  picture::PixelGrid grid;
  std::optional<picture::PixelGrid> truth{};  // where it is not that of the comparison
  std::string against = "the column oracle";
};

struct ComparedVectors {
  std::string name;  // "native lines"
  picture::LineMetrics metrics;
  picture::LineDifference difference;  // without stretches of up to a point of the screen
};

struct HeightComparison {
  guests::skala::View view;
  picture::PixelGrid truth;
  std::vector<ComparedRaster> rasters;
  std::vector<ComparedVectors> vectors;
  std::string guest_difference;  // from its twin; empty: identical in every dot, mask and status
  core::TStates guest_time{};

  [[nodiscard]] bool agrees() const { return guest_difference.empty(); }
};

// Empty if it can be compared.
[[nodiscard]] std::optional<std::string> why_not_comparable(const scene::HeightGrid& grid,
                                                            const guests::skala::View& view);

// On the EF9365 board, whatever the view asks for. The grid and the view can be compared (precondition).
[[nodiscard]] HeightComparison compare_heights(
    const scene::HeightGrid& grid, const guests::skala::View& view,
    const std::function<void(std::string_view)>& progress = [](std::string_view) {});

}  // namespace sightline::compare
