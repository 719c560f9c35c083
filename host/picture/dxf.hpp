// A drawing as DXF of AutoCAD release 12, which every CAD and cutting program reads: polylines in millimetres, with one
// coloured layer for each layer of the drawing.
// Source: Autodesk, AutoCAD Release 12 Customization Manual, chapter 11.
#pragma once

#include <string>

#include "host/picture/vector_drawing.hpp"

namespace sightline::picture {

// Positions are millimetres from the paper's bottom left corner. The format has no facets; they are omitted.
[[nodiscard]] std::string dxf_of(const VectorDrawing& drawing, const Paper& paper);

}  // namespace sightline::picture
