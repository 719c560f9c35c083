// Labels contour lines: a line is interrupted and its height written in the gap, along the line and never upside down,
// where the line is straight and no other line is near.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "host/picture/vector_drawing.hpp"

namespace sightline::algorithms::skala {

struct LabelledLayer {
  std::uint32_t layer = 0;
  std::string text;
};

// The drawing is in millimetres. The longest line of a level that has space for a label gets one, and so does every line
// longer than 12 text heights; long lines get another label every 60 text heights.
void add_contour_labels(picture::VectorDrawing& drawing, std::span<const LabelledLayer> layers, std::uint32_t label_layer, double text_height);

}  // namespace sightline::algorithms::skala
