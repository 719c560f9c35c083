// Compares one view of a function by Skala's program on each of its devices, the dots of the boards and the steps of
// the plotters, with the exact lines put on the same points by the program's rule, and with the unrounded lines
// between samples.
//
// A plotter cannot shade: it draws the slices of a surface. Of a plotter's other differences from a board
// (firmware/i8080/skala/SPECIFICATION.md, section 8), the rule drops runs of one dot, but does not continue a run
// where it touches the mask. The outline of contours depends on more than depth and is left out.
//
// Contours are tested with a tolerance of one dot; otherwise they would have gaps at their ends. Contours just behind
// the horizon are therefore drawn and count as extra dots here.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "emulators/core/tstates.hpp"
#include "host/algorithms/skala/view.hpp"
#include "host/programs/skala/commands.hpp"
#include "host/picture/dots_and_lines.hpp"
#include "host/picture/pixel_metrics.hpp"
#include "host/picture/raster_difference.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::compare {

struct ComparedDevice {
  programs::skala::Device device = programs::skala::Device::ef9365;
  std::string_view name;     // "ef9365", "alt256", "calcomp", "minigraf"
  std::string difference;    // how the program differs from its twin, or why it failed; else empty
  core::TStates time{};      // of the drawing
  picture::PixelGrid dots;   // lit, or marked by the pen, without the outline of contours
  picture::PixelGrid truth;  // exact lines by the program's rule; for a surface on a board, where a cell is visible
  picture::RasterDifference raster;
  std::optional<picture::DotsAndLines> unrounded;  // not for a surface on a board, which is filled
};

// The grid and the view can be compared (why_not_comparable is empty: precondition).
[[nodiscard]] std::vector<ComparedDevice> compare_devices(
    const scene::HeightGrid& grid, const algorithms::skala::View& view,
    const std::function<void(std::string_view)>& progress = [](std::string_view) {}, bool ef9365_alone = false);

}  // namespace sightline::compare
