// Labels in contour lines: the line is interrupted and its height written there, along it and never upside down, where the line is
// straight and no other line is near.
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

// The drawing is in millimetres. The longest line of a level that has room for a label gets one, others from 12 times its height on; a
// long one another for every 60 of them.
void add_contour_labels(picture::VectorDrawing& drawing, std::span<const LabelledLayer> layers, std::uint32_t label_layer, double text_height);

}  // namespace sightline::algorithms::skala
