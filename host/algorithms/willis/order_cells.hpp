// Order cells: the order of surfaces that touch, which neither distances nor any number of cuts can decide.
//
// If two surfaces touch and one can obscure the other, space is divided by the plane of one of them (as Schumacker did
// for clusters of faces): surfaces on the eye's side come before those in the plane, and these before those beyond it.
// Surfaces in different cells are never compared by distance. So solids that are not convex are divided into convex
// parts, and parts that touch are separated. A plane is only used if it cuts surfaces at lattice points; touching
// surfaces without such a plane stay in one cell.
#pragma once

#include <cstdint>
#include <vector>

#include "host/algorithms/willis/surface.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::willis {

// The number of a node or, if negative, ~ the number of a cell.
using OrderPlace = std::int32_t;

struct OrderNode {
  SurfacePlane plane;
  OrderPlace before = 0;  // on the side the normal points to
  OrderPlace in = 0;
  OrderPlace behind = 0;
};

struct OrderCells {
  std::vector<OrderNode> nodes;
  OrderPlace root = ~0;
  std::uint32_t cells = 1;
};

// Whether the two touch and one can obscure the other.
[[nodiscard]] bool touching_conflict(const Surface& s, const Surface& t);

// Sets the cell of every surface and cuts surfaces where needed, into at most `most` pieces.
[[nodiscard]] OrderCells make_order_cells(std::vector<Surface>& surfaces, std::size_t most);

// ranks[c]: the rank of cell c as seen by the camera, greater if it comes before others.
void rank_cells(const OrderCells& cells, const scene::PolyCamera& camera, std::vector<std::uint32_t>& ranks);

}  // namespace sightline::algorithms::willis
