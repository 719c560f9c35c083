// Time against error of methods and their variants as a drawing: both axes logarithmic, emulated seconds and seconds of this
// computer on panels of their own, points without error in a strip below, where errors of less than a thousandth of a per cent
// stand with their number.
//
// A series is one machine with one adjustable method, or an exact method. Of each the front is marked: the variants of which no
// other is both at least as fast and at least as right. Their marks are filled and joined by a line; those of the others are
// hollow.
//
// Without scripts, in fonts of the reader's computer, with colours for light and dark grounds. Equal points give equal bytes.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"

namespace sightline::compare {

enum class PlotPanel : std::uint8_t { emulated, host };

struct PlotPoint {
  PlotPanel panel = PlotPanel::emulated;
  std::string series;        // "PDP-7 with EAE", "exact"
  std::string label;         // of the variant, "3 bits"; empty: the series has one
  double seconds = 0;        // of a view, greater than 0
  double wrong_percent = 0;  // of what is truly seen; 0: none
};

// The numbers of the points of one series that are its front, ascending by time. Of equal points the first.
[[nodiscard]] std::vector<std::size_t> front_of(const std::vector<PlotPoint>& series);

// Points of one panel, series and label as one: the median of their seconds and of their wrong shares. In the order in which they
// came first. Of an even number the lower median.
[[nodiscard]] std::vector<PlotPoint> medians_of(const std::vector<PlotPoint>& points);

// A panel as an SVG element for a page, so large that its letters are readable at a width of 350 pixels. A panel without points
// says so.
[[nodiscard]] std::string panel_svg(const std::vector<PlotPoint>& points, PlotPanel panel);

// Both panels side by side as a file, with a title above that is escaped here. Error: there is nothing to plot.
[[nodiscard]] base::Result<std::string> plot_svg(const std::vector<PlotPoint>& points, std::string_view title);

}  // namespace sightline::compare
