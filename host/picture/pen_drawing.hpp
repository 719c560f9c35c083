// A plotter's drawing as an image and as an SVG in millimetres.
//
// The width of an ink line is not modelled. The image shows every step of the pen as one dot of `scale` pixels; the SVG
// has a pen of 0.3 mm.
#pragma once

#include <span>
#include <string>

#include "host/picture/image.hpp"
#include "host/picture/pen_path.hpp"

namespace sightline::picture {

// Grey, black on white: paper.steps * scale pixels per side, each point of the path a square of `scale` by `scale`.
// Points off the paper are left out.
[[nodiscard]] Image pen_image(std::span<const PenPath> paths, const PlotterPaper& paper, int scale);

// One user unit is one millimetre, each path is one polyline, all in one Inkscape layer with the pen's number first ("1
// pen"), because plotter programs select layers by number. Step (0, 0) is at a margin of 10 mm from the left and from the
// bottom. A dot becomes a dash of 0.02 mm, because many programs do not draw a path of length 0.
[[nodiscard]] std::string pen_svg(std::span<const PenPath> paths, const PlotterPaper& paper,
                                  const std::string& title);

}  // namespace sightline::picture
