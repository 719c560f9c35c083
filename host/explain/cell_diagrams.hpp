// The graph of a scene's cells and a diagram of each cell with its portals, as a drawing of lines.
//
// Source: Jones 1971, Fig. 3 (each node represents a cell and each arc an opening) and Fig. 7 (the diagrams from which
// a scene was coded).
#pragma once

#include <cstddef>

#include "host/base/result.hpp"
#include "host/picture/vector_drawing.hpp"
#include "host/scene/model/cell_complex.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::explain {

inline constexpr std::size_t most_cell_diagrams = 1000;

// In millimetres. The first field is the graph: a ring with its number for each cell, a line for each pair of cells that
// portals join (with their number, if there are several). Then a field for each cell: its edges, those at the back
// dashed; the parts of the scene's lines on it; its portals to other cells, each with the number of the cell beyond, and in
// the title the number of those that lead out. A diagram fills its field: fields have different scales. The camera only
// says which side is the front.
// Error usage: there are more than most_cell_diagrams cells.
[[nodiscard]] base::Result<picture::VectorDrawing> cell_diagrams(const scene::CellComplex& complex, const scene::PolyCamera& camera);

}  // namespace sightline::explain
