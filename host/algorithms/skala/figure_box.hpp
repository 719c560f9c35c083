// The box of axes around a surface: which edges are drawn and what of them can be seen, and the edges that carry ticks.
#pragma once

#include <array>
#include <vector>

#include "host/algorithms/skala/coverage.hpp"
#include "host/algorithms/skala/surface.hpp"

namespace sightline::algorithms::skala {

// A corner in the box's own terms: x, z and height.
using BoxPoint = std::array<double, 3>;

struct BoxEdge {
  BoxPoint from;
  BoxPoint to;
};

// x and z run from -1 to 1, heights from low to high.
struct Box {
  double low = -1;
  double high = 1;
};

// What of the box can be seen. Faces that are turned to the eye are before the surface; an edge of two such faces is left out.
// `coverage` is that of the surface, which lies within the box (precondition); null: it hides nothing.
[[nodiscard]] std::vector<BoxEdge> visible_box(const Surface& surface, const Box& box, const Coverage* coverage);

// An edge with ticks, and in which direction of the box they lead away from it.
struct TickEdge {
  BoxEdge edge;
  BoxPoint outward;
};

// Of x, z and height: edges on the outline of the box on the screen, those of x and z below, that of the heights at the left.
[[nodiscard]] std::array<TickEdge, 3> tick_edges(const Surface& surface, const Box& box);

}  // namespace sightline::algorithms::skala
