// A drawing as PDF 1.5, in millimetres, with a layer (optional content) for each layer of the drawing. Without dates and
// compression: the same drawing gives the same bytes.
// Source: Adobe, PDF Reference, fifth edition (version 1.6), 4.10 (optional content), 3.4 (file structure).
#pragma once

#include <string>

#include "host/picture/vector_drawing.hpp"

namespace sightline::picture {

// Facets are painted first, as in SVG; a line of one point is a dot of the pen's width.
[[nodiscard]] std::string pdf_of(const VectorDrawing& drawing, const Paper& paper, const std::string& title);

}  // namespace sightline::picture
