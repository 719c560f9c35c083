// The box of axes around a surface: the visible parts of its edges, and the edges that carry ticks.
#pragma once

#include <array>
#include <vector>

#include "host/algorithms/skala/coverage.hpp"
#include "host/algorithms/skala/surface.hpp"

namespace sightline::algorithms::skala {

// A point in coordinates of the box: x, z and height.
using BoxPoint = std::array<double, 3>;

struct BoxEdge {
  BoxPoint from;
  BoxPoint to;
};

// x and z range from -1 to 1, heights from low to high.
struct Box {
  double low = -1;
  double high = 1;
};

// The visible parts of the box. Faces turned to the eye are before the surface; an edge between two such faces is
// omitted. `coverage` is that of the surface, which lies within the box (precondition); null: it hides nothing.
[[nodiscard]] std::vector<BoxEdge> visible_box(const Surface& surface, const Box& box, const Coverage* coverage);

// An edge with ticks, and the direction in the box in which they point away from it.
struct TickEdge {
  BoxEdge edge;
  BoxPoint outward;
};

// The edges for x, z and height, all on the outline of the box on the screen: those for x and z at the bottom, that for
// the height on the left.
[[nodiscard]] std::array<TickEdge, 3> tick_edges(const Surface& surface, const Box& box);

}  // namespace sightline::algorithms::skala
