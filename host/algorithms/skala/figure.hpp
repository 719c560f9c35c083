// Draws a surface as a figure for a page, in millimetres: true proportions, a box of axes with ticks and labels, labelled
// contours, contours on the floor of the box, a colour legend and a title.
//
// The surface lies within the box. Therefore edges on a face of the box that is turned to the eye are before the surface;
// of the other edges, the parts not behind the surface (coverage.hpp) are visible. The three edges that meet in the
// corner nearest to the eye are omitted, because they would cross the picture. Ticks and labels are outside the box's
// outline, where nothing hides them.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "host/algorithms/skala/view.hpp"
#include "host/picture/vector_drawing.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::algorithms::skala {

struct FigureOptions {
  double width = 180;  // of the figure, mm
  double height = 180;
  double text = 2.5;      // height of a capital, mm
  bool stretch = false;   // scale each direction separately to fill the page
  bool axes = false;
  bool contour_labels = false;
  bool floor = false;     // draw contours on the floor, which is then lower than the surface
  bool legend = false;    // for the colours of heights
  std::string title = {};
  std::array<std::string, 3> names = {};  // of x, of the second variable and of the height; empty: none
};

// A figure and its proportions.
struct Figure {
  picture::VectorDrawing drawing;
  BoxSides sides;
  std::array<double, 2> scale{};  // mm per unit across and up; equal unless stretched
};

// The layers of draw(), then one layer per level of the floor's contours, then axes and labels, as requested. For several
// surfaces (draw.hpp) the floor has the contours of each, in its colour.
[[nodiscard]] Figure figure(std::span<const scene::HeightGrid> grids, const View& view, const FigureOptions& options);

}  // namespace sightline::algorithms::skala
