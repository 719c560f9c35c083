// Skala's program in `sightline demo`: the eight functions of the figures as lines, as shaded surfaces and as contours on the
// raster board, and one of them on a plotter.
#pragma once

#include <string>
#include <vector>

#include "host/app/commands/skala_pictures.hpp"
#include "host/base/json.hpp"

namespace sightline::app {

struct SkalaDemoRow {
  std::string function;
  programs::skala::Outcome lines;
  programs::skala::Outcome surface;
  programs::skala::Outcome contours;
};

struct SkalaDemo {
  std::vector<SkalaDemoRow> rows;
  std::string plotted;  // the function on the CalComp
  programs::skala::Outcome plot;
};

// Writes FUNCTION-lines.png, -surface.png, -contours.png and the plotter's files into `directory`. Error as
// programs::skala::run, or io.
[[nodiscard]] SkalaDemo run_skala_demo(const std::string& directory);

[[nodiscard]] std::string skala_demo_table(const SkalaDemo& demo);
// Adds "skala" and "skala_plot".
void add_skala_demo(base::Json& document, const SkalaDemo& demo);

}  // namespace sightline::app
