// Plotters by name, and drawings in their language.
//
// A plotter draws within limits that are smaller than its paper. The drawing is placed so that the paper's middle is the
// middle of the limits. The caller must reject drawings that exceed them (plotting_area); a drawing is never stretched to
// fit.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"
#include "host/picture/pen_order.hpp"
#include "host/picture/vector_drawing.hpp"

namespace sightline::picture {

inline constexpr int most_hpgl_pens = 8;

struct PlotterPaperLimits {
  std::string_view paper;
  double width = 0;  // of the paper in mm, the longer side
  double height = 0;
  int x = 0;  // greatest plotter units, from 0; 0 for a drum plotter, which has `carriage` and `length` instead
  int y = 0;
};

struct Plotter {
  std::string_view name;
  std::string_view description;
  int pens = most_hpgl_pens;
  PlotterSpeeds speeds;
  std::array<PlotterPaperLimits, 4> papers = {};  // the first is used, in its orientation, unless a size is given
  // Of a drum plotter: the travel of the pen along the height of the paper, in mm. 0: not a drum plotter.
  double carriage = 0;
  double length = 0;  // mm of paper whose steps a step file can count
};

// The first is the default: its plotting time is given unless another plotter is named.
// Limits: HP 7475A and 7550A Interfacing and Programming Manuals, tables of plotting areas.
[[nodiscard]] std::span<const Plotter> plotters();
[[nodiscard]] const Plotter* find_plotter(std::string_view name);

struct HpglOptions {
  const Plotter* plotter = nullptr;   // null: any, without limits
  std::vector<int> pens = {};    // by layer; empty: 1, 2, 3 ...
  std::optional<double> speed = {};   // cm/s with the pen down
  bool relative = false;              // coordinates relative to the previous point
};

// The area that the plotter can draw on this paper, around its middle: width and height in mm, at most those of the
// paper. Error: the plotter does not take that paper.
[[nodiscard]] base::Result<std::array<double, 2>> plotting_area(const Plotter& plotter, const Paper& paper);
// The least margin of the paper, in mm, that makes the drawing fit the plotter's limits. Errors as above.
[[nodiscard]] base::Result<double> least_margin(const Plotter& plotter, const Paper& paper);

// The pen that draws a layer. Each layer has its own pen while there are enough; the last pen draws the remaining layers.
[[nodiscard]] int pen_of_layer(std::size_t layer, const HpglOptions& options);
// The number of pens available for layers.
[[nodiscard]] std::size_t pen_count(const HpglOptions& options);
// The requested speed, limited to the plotter's; nullopt if none was requested.
[[nodiscard]] std::optional<double> reachable_speed(const HpglOptions& options);

// Plotter units of 0.025 mm, absolute unless `relative`, each point rounded once; consecutive equal points are written
// once. Facets are omitted, because a plotter cannot fill. Precondition: the drawing is within the plotting_area.
[[nodiscard]] std::string hpgl_of(const VectorDrawing& drawing, const Paper& paper, const HpglOptions& options = {});

}  // namespace sightline::picture
