// See svg.hpp.
#include "host/picture/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <iterator>

#include "host/picture/stroke_sinks.hpp"
#include "host/picture/xml_text.hpp"

namespace sightline::picture {

namespace {

// Half the length of the dash that stands for a lone point, and the pen's width (the 0.015 in of the spot).
constexpr std::int64_t half_dash_tenths = 100;  // tenths of a micrometre
constexpr const char* pen_millimetres = "0.381";

bool one_step_apart(LatticePoint a, LatticePoint b) {
  return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)) == 1;
}

int direction_of(int value) {
  return (value > 0) - (value < 0);
}

// Does b -> c go on in the direction of a -> b? Both run along one of the eight directions of the lattice.
bool straight(LatticePoint a, LatticePoint b, LatticePoint c) {
  return direction_of(b.x - a.x) == direction_of(c.x - b.x) &&
         direction_of(b.y - a.y) == direction_of(c.y - b.y);
}

// Middle of point `index` of the 1024, in tenths of a micrometre, rounded to the nearest.
std::int64_t tenths_of_micrometres(int index) {
  constexpr std::int64_t screen = 2381250;
  return ((2 * std::int64_t{index} + 1) * screen + screen_points) / (2 * screen_points);
}

void append_tenths(std::string& text, std::int64_t tenths) {
  fmt::format_to(std::back_inserter(text), "{}.{:04}", tenths / 10000, tenths % 10000);
}

void append_position(std::string& text, std::int64_t across, std::int64_t down) {
  append_tenths(text, across);
  text += ',';
  append_tenths(text, down);
}

void append_polyline(std::string& text, const Polyline& line) {
  text += "    <polyline points=\"";
  if (line.corners.size() == 1) {
    const std::int64_t across = tenths_of_micrometres(line.corners.front().x);
    const std::int64_t down = tenths_of_micrometres(screen_points - 1 - line.corners.front().y);
    append_position(text, across - half_dash_tenths, down);
    text += ' ';
    append_position(text, across + half_dash_tenths, down);
  } else {
    for (const LatticePoint& corner : line.corners) {
      if (&corner != &line.corners.front()) text += ' ';
      append_position(text, tenths_of_micrometres(corner.x),
                      tenths_of_micrometres(screen_points - 1 - corner.y));
    }
  }
  text += "\"/>\n";
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
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" "
      "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"\n"
      "     width=\"{0:.3f}mm\" height=\"{0:.3f}mm\" viewBox=\"0 0 {0:.3f} {0:.3f}\">\n"
      "  <title>{1}</title>\n",
      screen_millimetres, xml_text(title));
  for (int intensity = 0; intensity < intensity_levels; ++intensity) {
    const auto in_layer = [intensity](const Polyline& line) { return line.intensity == intensity; };
    if (std::none_of(lines.begin(), lines.end(), in_layer)) continue;
    fmt::format_to(
        std::back_inserter(text),
        "  <g id=\"intensity-{0}\" inkscape:groupmode=\"layer\" inkscape:label=\"{0} intensity {0}\"\n"
        "     fill=\"none\" stroke=\"#000000\" stroke-width=\"{1}\" stroke-linecap=\"round\" "
        "stroke-linejoin=\"round\">\n",
        intensity, pen_millimetres);
    for (const Polyline& line : lines) {
      if (in_layer(line)) append_polyline(text, line);
    }
    text += "  </g>\n";
  }
  text += "</svg>\n";
  return text;
}

}  // namespace sightline::picture
