// The way of a pen: lines joined, short gaps closed, corners that are none left out, and an order in which the pen
// travels little in the air. Every plotter and every program that drives one gets its lines in this order.
//
// Lines of a layer whose ends meet become one, the straightest continuation first where several meet; so the
// pen is lifted as rarely as the drawing allows. Then the order: the nearest end next, from the bottom left
// corner, a line in either direction and a closed one from any of its corners; improved by turning parts of
// the way round and by moving up to three lines elsewhere as long as that shortens it (2-opt and Or-opt over
// near neighbours). Deterministic. Layers keep their order, and each begins where the one before it ended.
#pragma once

#include <cstddef>
#include <vector>

#include "host/picture/vector_drawing.hpp"

namespace sightline::picture {

struct PenOptions {
  double join = 0.005;      // mm: ends so near to each other are one place
  double min_gap = 0;       // mm: gaps between ends shorter than this are drawn
  double straight = 0.001;  // mm: a corner so near to the straight line is left out
};

// The same drawing in the order of a pen on this paper, which says what a millimetre is. Facets stay as they are.
[[nodiscard]] VectorDrawing in_pen_order(const VectorDrawing& drawing, const Paper& paper, const PenOptions& options = {});

// What a drawing costs a pen, in its order of lines and layers, from the paper's bottom left corner on.
struct PenTravel {
  double down = 0;  // mm drawn
  double up = 0;    // mm in the air
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
// Seconds that the drawing takes: each straight line from rest to rest.
[[nodiscard]] double plot_seconds(const VectorDrawing& drawing, const Paper& paper, const PlotterSpeeds& speeds);

}  // namespace sightline::picture
