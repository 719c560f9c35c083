// The host computer of Skala (1985), section 6: "the time of function computation, scaling and rotation is not included,
// because a host computer was used". It converts a grid and a view to the bytes that the Skala program on the 8080 draws.
//
// The host decides everything that the 8080 cannot: the order from near to far, the rims (the domain's edges between the
// ends of slices, without which farther curves would show beside the surface), the columns that a hole leaves undefined,
// and the course of contour lines. Every chain between two COMMITs is monotone in x.
#pragma once

#include <cstdint>
#include <vector>

#include "host/programs/skala/projection.hpp"
#include "host/algorithms/skala/view.hpp"
#include "host/programs/skala/commands.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::programs::skala {

// The stream from DEVICE to END. The grid may have any size from one point up and any undefined heights; the view must be
// as its comments say, with 1 to 255 levels. A surface is always one family of slices (Family::both counts as automatic).
// Contours are drawn by cells; only they have silhouettes and the net.
[[nodiscard]] std::vector<std::uint8_t> stream_of(const scene::HeightGrid& grid, const View& view, const Output& output = {});

// Levels 1..7 of a shaded surface, in the order of the grid's heights: from the x component of the unit normal of the
// normalised surface (h scaled by 0.6), by central differences, one-sided at the border and beside an undefined height.
[[nodiscard]] std::vector<int> shades(const scene::HeightGrid& grid);

inline constexpr int line_colour = 7;

}  // namespace sightline::programs::skala
