#include "host/picture/stroke_drawing.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "host/picture/stroke_recorders.hpp"
#include "host/picture/svg.hpp"

namespace sightline::picture {

namespace {

// The pen's width: the 0.015 in of the spot.
constexpr const char* pen_millimetres = "0.381";

bool one_step_apart(LatticePoint a, LatticePoint b) {
  return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)) == 1;
}

int direction_of(int value) {
  return (value > 0) - (value < 0);
}

// Whether b -> c continues in the direction of a -> b. Both are along one of the eight directions of the lattice.
bool straight(LatticePoint a, LatticePoint b, LatticePoint c) {
  return direction_of(b.x - a.x) == direction_of(c.x - b.x) &&
         direction_of(b.y - a.y) == direction_of(c.y - b.y);
}

// The middle of point `index` of the 1024, in tenths of a micrometre, rounded to nearest.
std::int64_t tenths_of_micrometres(int index) {
  constexpr std::int64_t screen = 2381250;
  return ((2 * std::int64_t{index} + 1) * screen + screen_points) / (2 * screen_points);
}

}  // namespace

std::vector<Polyline> join_strokes(std::span<const core::Stroke> strokes) {
  std::vector<Polyline> lines;
  for (const core::Stroke& stroke : strokes) {
    if (!on_screen(stroke)) continue;
    const LatticePoint point{stroke.x, stroke.y};
    if (lines.empty() || lines.back().intensity != stroke.intensity) {
      lines.push_back({stroke.intensity, {point}});
      continue;
    }
    auto& corners = lines.back().corners;
    if (corners.back() == point) continue;
    if (!one_step_apart(corners.back(), point)) {
      lines.push_back({stroke.intensity, {point}});
    } else if (corners.size() >= 2 && straight(corners[corners.size() - 2], corners.back(), point)) {
      corners.back() = point;
    } else {
      corners.push_back(point);
    }
  }
  return lines;
}

std::string svg_drawing(std::span<const core::Stroke> strokes, const std::string& title) {
  const auto lines = join_strokes(strokes);
  SvgWriter svg(screen_millimetres, screen_millimetres, title, {.decimals = 4});
  const auto across = [](LatticePoint at) { return tenths_of_micrometres(at.x); };
  const auto down = [](LatticePoint at) { return tenths_of_micrometres(screen_points - 1 - at.y); };
  for (int intensity = 0; intensity < intensity_levels; ++intensity) {
    const auto in_layer = [intensity](const Polyline& line) { return line.intensity == intensity; };
    if (std::none_of(lines.begin(), lines.end(), in_layer)) continue;
    svg.open_lines(fmt::format("intensity-{}", intensity), fmt::format("{0} intensity {0}", intensity), {},
                   pen_millimetres);
    for (const Polyline& line : lines) {
      if (!in_layer(line)) continue;
      svg.begin_polyline();
      if (line.corners.size() == 1)
        svg.dot(across(line.corners.front()), down(line.corners.front()));
      else
        for (const LatticePoint corner : line.corners) svg.point(across(corner), down(corner));
      svg.end_shape();
    }
    svg.close_layer();
  }
  return std::move(svg).finish();
}

}  // namespace sightline::picture
