// Draws text as single strokes of our own shapes: it looks the same in an image, an SVG and on a plotter, and needs no
// font.
//
// Printable ASCII, proportionally spaced; digits have equal widths, so columns of numbers are aligned. Any other
// character is drawn as a box.
#pragma once

#include <cstdint>
#include <string_view>

#include "host/picture/vector_drawing.hpp"

namespace sightline::picture {

struct TextDirection {
  double x = 1;  // of length 1
  double y = 0;
};

// `height` is the height of a capital; lower-case letters are two thirds of it, descenders another third. The text begins
// at (x, y) on its baseline. Returns the x of its end, for text to the right.
double append_text(VectorDrawing& drawing, std::uint32_t layer, double x, double y, double height,
                   std::string_view text, TextDirection direction = {});
// The width of the same text, from its start to the end of its last sign.
[[nodiscard]] double text_width(double height, std::string_view text);

// Appends a line of two points, or a dot if they are equal.
void append_line(VectorDrawing& drawing, std::uint32_t layer, double x0, double y0, double x1, double y1);

}  // namespace sightline::picture
