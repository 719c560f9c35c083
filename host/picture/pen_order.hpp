// Optimizes the travel of a pen: joins lines, closes short gaps, removes corners on straight lines, and orders the lines
// so that the pen travels little in the air. All files for plotters and for programs that drive them have this order.
//
// Lines of a layer whose ends meet become one, straightest continuation first; so the pen is lifted as rarely as the
// drawing allows. Lines are ordered by the nearest end, starting at the bottom left corner; a line is drawn in either
// direction, a closed line from any corner. The order is then improved by reversing parts of the tour and by moving up to
// three lines elsewhere while that shortens it (2-opt and Or-opt over near neighbours). Deterministic. Layers keep their
// order, and each begins where the one before it ended.
#pragma once

#include <cstddef>
#include <vector>

#include "host/picture/vector_drawing.hpp"

namespace sightline::picture {

struct PenOptions {
  double join = 0.005;      // mm: ends this near to each other are one place
  double min_gap = 0;       // mm: shorter gaps between ends are closed
  double straight = 0.001;  // mm: a corner this near to the straight line is removed
};

// The same drawing in pen order on this paper, which defines the millimetre. Facets are unchanged.
[[nodiscard]] VectorDrawing in_pen_order(const VectorDrawing& drawing, const Paper& paper, const PenOptions& options = {});

// What plotting a drawing takes, in its order of lines and layers, starting at the paper's bottom left corner.
struct PenTravel {
  double down = 0;  // mm drawn
  double up = 0;    // mm travelled with the pen up
  std::size_t lifts = 0;
  std::size_t lines = 0;
  std::size_t pens = 0;  // layers with lines
};
[[nodiscard]] PenTravel pen_travel(const VectorDrawing& drawing, const Paper& paper);

// Speeds of a plotter, in mm and seconds.
struct PlotterSpeeds {
  double down = 0;
  double up = 0;
  double acceleration = 0;
  double lift = 0;       // to raise or lower the pen
  double pen_change = 0;
};
// The plotting time in seconds, if each straight line is drawn from rest to rest.
[[nodiscard]] double plot_seconds(const VectorDrawing& drawing, const Paper& paper, const PlotterSpeeds& speeds);

}  // namespace sightline::picture
