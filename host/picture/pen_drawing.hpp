// What a plotter drew, as an image and as an SVG drawing in millimetres.
//
// Left out: the width of the line as ink makes it. The image shows every step the pen made as one dot of
// `scale` pixels; the SVG has a pen of 0.3 mm.
#pragma once

#include <span>
#include <string>

#include "host/picture/image.hpp"
#include "host/picture/pen_path.hpp"

namespace sightline::picture {

// Grey, black on white: paper.steps * scale pixels a side, each point of the path a square of `scale` by
// `scale`. Points off the paper are left out.
[[nodiscard]] Image pen_image(std::span<const PenPath> paths, const PlotterPaper& paper, int scale);

// One user unit is one millimetre, one polyline a path, all in one Inkscape layer with the pen's number first
// ("1 pen"), as plotter programs that pick layers by number want it; step (0, 0) is a margin of 10 mm
// from the left and from the bottom. A dot becomes a dash of 0.02 mm, because many programs do not draw a
// path of no length.
[[nodiscard]] std::string pen_svg(std::span<const PenPath> paths, const PlotterPaper& paper,
                                  const std::string& title);

}  // namespace sightline::picture
