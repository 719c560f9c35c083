// Finds the start cells of a view: the cells that contain the eye, or the outside.
//
// Around the eye, free space is one piece or several: two cells whose closures contain the eye belong to one piece if an
// opening that contains the eye joins them. Inside a cell, in an opening or on its boundary, on the surface of a solid,
// and at the free edge of a wall there is one piece, and all its cells are start cells. On a wall there are two pieces,
// at a corner of walls more. Then the piece that the eye looks into counts (along forward; along a plane, to the right of
// it; along a line, above it); if the eye looks into matter, the piece of the lowest-numbered cell.
//
// An orthographic view starts outside, the eye being infinitely far away. So does a view from beyond or on the outer box.
#pragma once

#include <optional>
#include <vector>

#include "host/algorithms/jones/prepared_complex.hpp"
#include "host/scene/model/cell_complex.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::jones {

struct Start {
  bool outside = false;
  std::vector<scene::CellNumber> cells;  // ascending
};

// nullopt if the eye is inside the outer box, but in no cell.
[[nodiscard]] std::optional<Start> find_start(const PreparedComplex& prepared,
                                              const scene::PolyCamera& camera);

}  // namespace sightline::algorithms::jones
