// The parts of a picture of Skala's program, and its counts: masks, a plotter's movements, points.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "emulators/core/time.hpp"
#include "host/picture/pen_path.hpp"

namespace sightline::programs::skala {

// The state of the screen's columns, by x: section 2 of the specification.
struct Columns {
  std::array<std::uint8_t, 256> mask_top{};        // MT
  std::array<std::uint8_t, 256> mask_bottom{};     // MB
  std::array<std::uint8_t, 256> previous_y{};      // MP, undefined where the level is 0
  std::array<std::uint8_t, 256> previous_level{};  // IP
  std::array<std::uint8_t, 256> raised_from{};     // LT, 0: nothing has raised the top since the last fold
  std::array<std::uint8_t, 256> lowered_from{};    // HB, 255: nothing has lowered the bottom
};

enum class PlotterAction : std::uint8_t { step, pen_up, pen_down };

// One movement of a plotter. x and y are the position of the pen after it, in steps from (0, 0); a step changes each by at
// most one.
struct PlotterMove {
  PlotterAction action = PlotterAction::step;
  std::uint8_t x = 0;
  std::uint8_t y = 0;
  bool pen_down = false;  // during a step; after a change of the pen

  friend bool operator==(const PlotterMove&, const PlotterMove&) = default;
};

struct Counts {
  std::uint64_t points_walked = 0;   // steps of lines, curves, slices and outlines, visible or not
  std::uint64_t points_plotted = 0;  // dots written to a raster board, a dot written twice counted twice;
                                     // visible points on a plotter, dropped ones included
  std::uint64_t pen_lifts = 0;
  std::uint64_t steps_pen_down = 0;
  std::uint64_t steps_pen_up = 0;
};

// Computes points_walked from a stream of commands and the final masks, which OUTLINE follows.
[[nodiscard]] std::uint64_t points_walked(std::span<const std::uint8_t> stream, const Columns& columns);

struct PlotterWork {
  std::uint64_t steps_pen_down = 0;
  std::uint64_t steps_pen_up = 0;
  std::uint64_t pen_lifts = 0;
  core::Duration time{};  // 1/300 s per step, 0.1 s per change of the pen
};
[[nodiscard]] PlotterWork plotter_work(std::span<const PlotterMove> moves);

// One path from each lowering of the pen to its lifting, in order; of a straight run only the ends are kept.
[[nodiscard]] std::vector<picture::PenPath> pen_paths(std::span<const PlotterMove> moves);

}  // namespace sightline::programs::skala
