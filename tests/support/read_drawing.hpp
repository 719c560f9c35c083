// Reads drawings back from their files by the rules of each format, sharing no code with the writers. Lines are in mm from the
// bottom left of the paper; a filled area of an SVG is a line as well.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace sightline::tests {

using DrawnLine = std::vector<std::pair<double, double>>;
using DrawnLines = std::vector<DrawnLine>;

// Paths of "M x y" followed by relative coordinates; a signed one needs no blank before it.
[[nodiscard]] DrawnLines lines_of_svg(const std::string& svg, double paper_height);
// From the contents of the page.
[[nodiscard]] DrawnLines lines_of_pdf(const std::string& pdf);
[[nodiscard]] DrawnLines lines_of_dxf(const std::string& dxf);
// In plotter units of 0.025 mm, absolute coordinates.
[[nodiscard]] DrawnLines lines_of_hpgl(const std::string& hpgl);
// In steps of the CalComp from the initial position of the pen.
[[nodiscard]] DrawnLines lines_of_steps(const std::string& steps);

// A straight part of a line.
using DrawnSegment = std::array<double, 4>;  // x, y, x, y
[[nodiscard]] std::vector<DrawnSegment> segments_of(const DrawnLines& lines);
[[nodiscard]] double distance_to(const DrawnSegment& segment, double x, double y);
// The largest distance of the ends and the middle of a segment from the nearest other segment: infinite if there are none.
[[nodiscard]] double distance_from(const std::vector<DrawnSegment>& others, const DrawnSegment& segment);

}  // namespace sightline::tests
