// A drawing as DXF of AutoCAD release 12, which every program for drawings and cutters reads: millimetres, a layer with
// a colour for each layer of the drawing, polylines.
// Source: Autodesk, AutoCAD Release 12 Customization Manual, chapter 11.
#pragma once

#include <string>

#include "host/picture/vector_drawing.hpp"

namespace sightline::picture {

// Positions are millimetres from the paper's bottom left corner. Facets have no place in it and are left out.
[[nodiscard]] std::string dxf_of(const VectorDrawing& drawing, const Paper& paper);

}  // namespace sightline::picture
