// Plots, drawn by gnuplot (Debian: gnuplot-nox) into SVG: this program says what is drawn, gnuplot how.
//
// Data and a script are written into a folder of their own under the system's folder for temporary files,
// which is removed. Equal plots give equal bytes from one version of gnuplot.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "host/report/document.hpp"
#include "host/report/experiment.hpp"

namespace sightline::report {

struct Axis {
  std::string title;
  std::string unit = {};  // put behind the title in brackets; empty: none
  // A value of 0 on a logarithmic axis, such as the error of an exact program, stands at the axis's low end,
  // a decade below the least other value, at a mark named 0. Negative values and what is no number are not
  // drawn.
  bool logarithmic = true;
  [[nodiscard]] bool shows(double value) const { return std::isfinite(value) && (!logarithmic || value >= 0); }
};

struct PlotPoint {
  double x = 0;
  double y = 0;
  std::string label = {};  // beside the point: "18 bits"
};

struct Curve {
  std::string name;  // in the legend
  std::vector<PlotPoint> points;
  bool line = true;  // joined in their order
  bool points_marked = true;
};

struct Plot {
  std::string id;  // these four as in the Figure made of it
  std::string title;
  Said caption;
  std::string alternative;
  Axis x;
  Axis y;
  std::vector<Curve> curves = {};
  int width = 860;  // of the SVG, in its units
  int height = 540;
};

// What gnuplot is given: data blocks and commands, without the line that names the output.
[[nodiscard]] std::string gnuplot_script(const Plot& plot);

// Error missing_tool: there is no gnuplot; file: it could not be run or did not draw, such as a plot without a point.
[[nodiscard]] base::Result<Figure> draw_plot(const Plot& plot);

// Nothing, if gnuplot can be run: ask before long measurements.
[[nodiscard]] std::optional<base::Error> gnuplot_missing();

}  // namespace sightline::report
