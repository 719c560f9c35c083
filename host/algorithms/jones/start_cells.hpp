// The start cells of a view: the cells that the eye is in, or outside.
//
// Around the eye, free space is one piece or several: cells whose closure has the eye are of one piece if an
// opening that has the eye joins them. In the inside of a cell, in an opening, on its rim, on the surface of
// a solid, at the free edge of a wall, there is one piece, and all its cells are start cells. On a wall there
// are two, at the corner of walls more: then the eye is in the piece it looks into (along forward; along a
// plane, to the right; along a line, up), or, looking into matter, in that of the lowest-numbered cell.
//
// An orthographic view begins outside, the eye infinitely far. So does one from beyond or on the outer box.
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

// Empty if the eye is inside the outer box, but in no cell.
[[nodiscard]] std::optional<Start> find_start(const PreparedComplex& prepared,
                                              const scene::PolyCamera& camera);

}  // namespace sightline::algorithms::jones
