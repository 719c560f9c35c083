#include "host/picture/pen_path.hpp"

#include <iterator>

#include "host/base/text.hpp"

namespace sightline::picture {

namespace {

int sign(int value) {
  return (value > 0) - (value < 0);
}

// Rounds to the nearest unit, halves up.
std::int64_t units(int steps, const PlotterPaper& paper) {
  const std::int64_t twice = 2 * steps * paper.micrometres_per_step + hpgl_unit_micrometres;
  const std::int64_t whole = twice / (2 * hpgl_unit_micrometres);
  return twice % (2 * hpgl_unit_micrometres) < 0 ? whole - 1 : whole;
}

void append_point(std::string& text, PenPoint point, const PlotterPaper& paper) {
  base::append(text, "{},{}", units(point.x, paper), units(point.y, paper));
}

}  // namespace

void extend(PenPath& path, PenPoint next) {
  auto& corners = path.corners;
  if (corners.back() == next) return;
  if (corners.size() >= 2) {
    const PenPoint a = corners[corners.size() - 2];
    const PenPoint b = corners.back();
    if (sign(b.x - a.x) == sign(next.x - b.x) && sign(b.y - a.y) == sign(next.y - b.y)) {
      corners.back() = next;
      return;
    }
  }
  corners.push_back(next);
}

std::string hpgl(std::span<const PenPath> paths, const PlotterPaper& paper) {
  std::string text = "IN;\nSP1;\n";
  for (const PenPath& path : paths) {
    if (path.corners.empty()) continue;
    text += "PU";
    append_point(text, path.corners.front(), paper);
    text += ";\nPD";
    std::size_t in_instruction = 0;
    for (std::size_t i = 1; i < path.corners.size(); ++i) {
      if (in_instruction == hpgl_most_corners) {
        text += ";\nPD";
        in_instruction = 0;
      }
      if (in_instruction++ > 0) text += ',';
      append_point(text, path.corners[i], paper);
    }
    text += ";\n";
  }
  text += "PU;\nSP0;\n";
  return text;
}

}  // namespace sightline::picture
