// Strokes as an SVG drawing in millimetres, at the size of the tube, for plotters and drawing programs.
//
// The screen is 9.375 in = 238.125 mm square (16ADP7 tube, DEC-340 manual); point (x, y) is the middle of a square of
// 1/1024 of its side. One user unit is one millimetre. Each intensity in use is an Inkscape layer, labelled with the
// number first ("7 intensity 7"), because plotter programs select layers by number. Consecutive strokes one step apart
// (also diagonally) become one polyline, of which only the ends of straight runs are kept: the points stay on the same
// lattice, to 0.1 um. An isolated point becomes a dash of 0.02 mm, because many programs do not draw a path of length 0.
// The brightness of repeated strokes is not shown.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "emulators/core/stroke.hpp"

namespace sightline::picture {

inline constexpr double screen_millimetres = 238.125;

struct LatticePoint {
  int x = 0;  // 0..1023 from the left
  int y = 0;  // 0..1023 from the bottom

  friend constexpr bool operator==(LatticePoint, LatticePoint) = default;
};

struct Polyline {
  int intensity = 0;
  // Consecutive corners differ by k * (sx, sy), sx and sy in -1..1: every lattice point between them was lit.
  std::vector<LatticePoint> corners;
};

// In drawing order. An isolated point is a polyline of one corner. Strokes off the screen are left out.
[[nodiscard]] std::vector<Polyline> join_strokes(std::span<const core::Stroke> strokes);

// `title` is the drawing's name; it is escaped here.
[[nodiscard]] std::string svg_drawing(std::span<const core::Stroke> strokes, const std::string& title);

}  // namespace sightline::picture
