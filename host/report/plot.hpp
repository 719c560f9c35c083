// Plots, drawn by gnuplot (Debian: gnuplot-nox) into SVG: this program says what is drawn, gnuplot how.
//
// Data and a script are written into a temporary folder, which is then removed. Equal plots give equal bytes with one
// version of gnuplot.
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
  std::string unit = {};  // appended to the title in brackets; empty: none
  // On a logarithmic axis, a value of 0, such as the error of an exact program, is at the low end, a decade below the
  // least other value, at a mark labelled 0. Negative values and NaN are not drawn.
  bool logarithmic = true;
  [[nodiscard]] bool shows(double value) const { return std::isfinite(value) && (!logarithmic || value >= 0); }
};

struct PlotPoint {
  double x = 0;
  double y = 0;
  std::string label = {};  // next to the point: "18 bits"
};

struct Curve {
  std::string name;  // in the legend
  std::vector<PlotPoint> points;
  bool line = true;  // joined in their order
  bool points_marked = true;
};

struct Plot {
  std::string id;  // these four as in the Figure made from it
  std::string title;
  CheckedText caption;
  std::string alternative;
  Axis x;
  Axis y;
  std::vector<Curve> curves = {};
  int width = 860;  // of the SVG, in its units
  int height = 540;
};

// The input of gnuplot: data blocks and commands, without the line that names the output.
[[nodiscard]] std::string gnuplot_script(const Plot& plot);

// Errors: missing_tool, there is no gnuplot; file, it could not be run or drew nothing, such as for a plot without
// points.
[[nodiscard]] base::Result<Figure> draw_plot(const Plot& plot);

// Empty if gnuplot can be run. To be called before long measurements.
[[nodiscard]] std::optional<base::Error> gnuplot_missing();

}  // namespace sightline::report
