// Plotters by name, and drawings in their language.
//
// A plotter draws within limits that are smaller than its paper. The drawing is placed so that the paper's middle is
// the middle of the limits; the caller refuses what would lie beyond them (plotting_area): it is never stretched to fit.
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
  int x = 0;  // the farthest plotter units, from 0; of a drum plotter, whose carriage and length are its limits, 0
  int y = 0;
};

struct Plotter {
  std::string_view name;
  std::string_view description;
  int pens = most_hpgl_pens;
  PlotterSpeeds speeds;
  std::array<PlotterPaperLimits, 4> papers = {};  // the first is in it unless a size is given, as it lies there
  // Of a drum plotter: how far the pen goes along the height of the paper, in mm; paper of any length. 0: no drum.
  double carriage = 0;
  double length = 0;  // mm of paper that a step file can count
};

// The first is the usual one: how long a drawing takes, unless another is named.
// Limits: HP 7475A and 7550A Interfacing and Programming Manuals, tables of plotting areas.
[[nodiscard]] std::span<const Plotter> plotters();
[[nodiscard]] const Plotter* find_plotter(std::string_view name);

struct HpglOptions {
  const Plotter* plotter = nullptr;   // null: any, without limits
  std::vector<int> pens = {};    // of the layers in their order; empty: 1, 2, 3 ...
  std::optional<double> speed = {};   // cm/s of the lowered pen
  bool relative = false;              // coordinates from point to point
};

// Where the plotter can draw on this paper, around its middle: width and height in mm, at most the paper's. An error if it
// does not take that paper.
[[nodiscard]] base::Result<std::array<double, 2>> plotting_area(const Plotter& plotter, const Paper& paper);
// The margin of the paper, in mm, with which the plotter can draw to its edge; an error as above.
[[nodiscard]] base::Result<double> least_margin(const Plotter& plotter, const Paper& paper);

// The pen that draws a layer: each has its own while there are pens, and the last pen draws all layers beyond.
[[nodiscard]] int pen_of_layer(std::size_t layer, const HpglOptions& options);
// How many pens layers can have.
[[nodiscard]] std::size_t pen_count(const HpglOptions& options);
// The speed that was asked for, at most the plotter's; empty: none was.
[[nodiscard]] std::optional<double> reachable_speed(const HpglOptions& options);

// Plotter units of 0.025 mm, absolute unless asked otherwise, each point rounded once; points that are equal then are
// written once. Facets have no place on a plotter and are left out. Of a drawing within the plotting_area (precondition).
[[nodiscard]] std::string hpgl_of(const VectorDrawing& drawing, const Paper& paper, const HpglOptions& options = {});

}  // namespace sightline::picture
