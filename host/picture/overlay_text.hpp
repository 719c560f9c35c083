// Text in a drawing, made of lines: legends look the same in an image, an SVG and on a plotter, and need
// no font.
#pragma once

#include <cstdint>
#include <string_view>

#include "host/picture/vector_drawing.hpp"

namespace sightline::picture {

// `height` is that of a capital; the text begins at (x, y), its baseline. Printable ASCII, small letters as
// capitals, a box for a character without a sign. Returns the end of the text.
double append_text(VectorDrawing& drawing, std::uint32_t layer, double x, double y, double height,
                   std::string_view text);
// Of the same text.
[[nodiscard]] double text_width(double height, std::string_view text);

// A line of two points, or a dot where they are the same.
void append_line(VectorDrawing& drawing, std::uint32_t layer, double x0, double y0, double x1, double y1);

}  // namespace sightline::picture
