// Text in a drawing, made of single strokes of a shape of our own: it looks the same in an image, an SVG and on a plotter,
// and needs no font.
//
// Printable ASCII, each sign as wide as it needs; figures are all of one width, so that columns of numbers line up.
// A box stands for any other character.
#pragma once

#include <cstdint>
#include <string_view>

#include "host/picture/vector_drawing.hpp"

namespace sightline::picture {

struct TextDirection {
  double x = 1;  // of length 1
  double y = 0;
};

// `height` is that of a capital; small letters are two thirds of it, and what goes below the baseline takes a third more.
// The text begins at (x, y) on its baseline. Returns the x of its end, for text to the right.
double append_text(VectorDrawing& drawing, std::uint32_t layer, double x, double y, double height,
                   std::string_view text, TextDirection direction = {});
// Of the same text, from its beginning to the end of its last sign.
[[nodiscard]] double text_width(double height, std::string_view text);

// A line of two points, or a dot where they are the same.
void append_line(VectorDrawing& drawing, std::uint32_t layer, double x0, double y0, double x1, double y1);

}  // namespace sightline::picture
