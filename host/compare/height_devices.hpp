// One view of a function by Skala's program on each of its devices: the dots of the boards and the steps of the plotters,
// against exact lines put on the same points by the program's rule, and against the unrounded lines between samples.
//
// A plotter cannot shade: of a surface it draws the slices. Of what it does otherwise than a board
// (firmware/i8080/skala/SPECIFICATION.md, section 8) the rule has that runs of one dot are dropped, not that a run goes on
// where it touches the mask. The outline of contours depends on more than depth and is left out.
//
// Contours are tested with a dot of slack, without which they would have gaps at their ends: those that run just behind
// the horizon are drawn, and are dots too many here.
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
  std::string difference;    // where the program is not its twin, or why it failed; empty: nowhere
  core::TStates time{};      // of drawing
  picture::PixelGrid dots;   // lit, or marked by the pen, without the outline of contours
  picture::PixelGrid truth;  // exact lines by the program's rule; of a surface on a board, where a cell is seen
  picture::RasterDifference raster;
  std::optional<picture::DotsAndLines> unrounded;  // not of a surface on a board, which is filled
};

// The grid and the view can be compared (why_not_comparable: precondition).
[[nodiscard]] std::vector<ComparedDevice> compare_devices(
    const scene::HeightGrid& grid, const algorithms::skala::View& view,
    const std::function<void(std::string_view)>& progress = [](std::string_view) {}, bool ef9365_alone = false);

}  // namespace sightline::compare
