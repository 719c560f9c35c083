// Filled areas with holes as SVG in millimetres: what an algorithm gives that rebuilds the outlines of what
// is seen of faces. Areas do not overlap (precondition), so that their order means nothing.
#pragma once

#include <string>
#include <vector>

#include "host/picture/line_metrics.hpp"
#include "host/picture/vector_drawing.hpp"

namespace sightline::picture {

// Closed lines; what lies inside an odd number of them is filled.
struct FilledArea {
  Colour colour;
  std::vector<std::vector<PixelPoint>> loops;  // micrometres from the bottom left of the paper's inside
};

// Cut to the inside of the paper. Positions are rounded to a micrometre.
[[nodiscard]] std::string svg_of(const std::vector<FilledArea>& areas, const Paper& paper,
                                 const std::string& title);

}  // namespace sightline::picture
