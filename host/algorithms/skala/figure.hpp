// A drawing of a surface as a figure for a page: true proportions, a box of axes with ticks and labels, labelled contours,
// contours on the floor of the box, a legend of colours and a title. All in millimetres.
//
// Which lines of the box can be seen: the surface lies within the box, so that an edge on a face that is turned to the eye is
// before it, and of all others what is not behind the surface (coverage.hpp). The three edges that meet in the corner nearest to the
// eye are left out, since they would cross the picture. Ticks and labels stand outside the box's outline, where nothing hides them.
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
  bool stretch = false;   // both directions fill the page, each by itself
  bool axes = false;
  bool contour_labels = false;
  bool floor = false;     // contours on the floor, which then lies below the surface
  bool legend = false;    // of the colours of heights
  std::string title = {};
  std::array<std::string, 3> names = {};  // of x, the second variable and the height; empty: none
};

// A figure, and what its proportions are.
struct Figure {
  picture::VectorDrawing drawing;
  BoxSides sides;
  std::array<double, 2> scale{};  // mm of a unit of the sides, across and up; equal unless it is stretched
};

// The layers of draw(), then those of the floor's contours, a level each, then axes and labels, as far as there are any.
// Of several surfaces (draw.hpp) the floor has the contours of each, in its colour.
[[nodiscard]] Figure figure(std::span<const scene::HeightGrid> grids, const View& view, const FigureOptions& options);

}  // namespace sightline::algorithms::skala
