// Order cells: the order of surfaces that touch, which no distance and no number of cuts can tell.
//
// Where two surfaces touch and one can obscure the other, space is divided by the plane of one of them (as
// Schumacker did for clusters of faces): what is on the eye's side comes before what is in the plane, and that
// before what is beyond. Surfaces in different cells are never compared by distance. So solids that are not
// convex fall into convex parts, and parts that touch are kept apart. A plane is only used if it cuts
// surfaces at points of the lattice; touching surfaces for which there is no such plane stay in one cell.
#pragma once

#include <cstdint>
#include <vector>

#include "host/algorithms/willis/surface.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::willis {

// A node's number, or, negative, ~ the number of a cell.
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

// The two touch, and one can obscure the other.
[[nodiscard]] bool touching_conflict(const Surface& s, const Surface& t);

// Sets every surface's cell, cutting surfaces where needed; never into more than `most` pieces.
[[nodiscard]] OrderCells make_order_cells(std::vector<Surface>& surfaces, std::size_t most);

// ranks[c]: a number for cell c, larger for what comes before; as seen by the camera.
void rank_cells(const OrderCells& cells, const scene::PolyCamera& camera, std::vector<std::uint32_t>& ranks);

}  // namespace sightline::algorithms::willis
