// Plots time against error of methods and their variants. Both axes are logarithmic. Emulated seconds and seconds of
// this computer have separate panels. Points without error are in a strip below the axis, and so are errors below a
// thousandth of a per cent, with their number.
//
// A series is one machine with one adjustable method, or an exact method. Its Pareto front is marked: the variants
// for which no other variant is at least as fast and at least as accurate. Their marks are filled and joined by a
// line; the others are hollow.
//
// No scripts, only the reader's fonts, colours for light and dark backgrounds. Equal points give equal bytes.
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
  std::string label;         // of the variant, "3 bits"; empty if the series has one variant
  double seconds = 0;        // per view, greater than 0
  double wrong_percent = 0;  // of what is visible; 0: none
};

// The indices of the points on the Pareto front of one series, ascending by time. Of equal points, the first.
[[nodiscard]] std::vector<std::size_t> front_of(const std::vector<PlotPoint>& series);

// Combines the points with equal panel, series and label into one with the median of their seconds and of their wrong
// shares (the lower median of an even number). In the order in which they first occur.
[[nodiscard]] std::vector<PlotPoint> medians_of(const std::vector<PlotPoint>& points);

// A panel as an SVG element for a page, with text large enough to read at a width of 350 pixels. A panel without
// points says so.
[[nodiscard]] std::string panel_svg(const std::vector<PlotPoint>& points, PlotPanel panel);

// Both panels side by side as a file, with a title, which is escaped here. Error: there are no points.
[[nodiscard]] base::Result<std::string> plot_svg(const std::vector<PlotPoint>& points, std::string_view title);

}  // namespace sightline::compare
