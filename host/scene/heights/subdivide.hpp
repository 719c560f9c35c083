// A finer grid through the heights of a grid: Skala (1985), section 5, for smooth contours: "if any user needs smaller grids or
// smoothly interpolate contours he can subdivide grid mesh".
#pragma once

#include <cstddef>

#include "host/base/result.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::scene {

// Into how many parts each cell is cut along x and along z; 1: not.
struct CellParts {
  std::size_t x = 1;
  std::size_t z = 1;
};

// Each cell in parts.x by parts.z cells. All heights of the grid remain. Between them runs a cubic curve along x, then along z,
// whose slope at a height is that of the parabola through it and its neighbours; the surface has no creases, and a
// parabola is reproduced exactly. A new place is a hole if one of the two heights beside it is; beside a hole, slopes use
// the neighbours that exist. The range grows if the curves leave it. Error: more points or slices than largest_grid.
[[nodiscard]] base::Result<HeightGrid> subdivided(const HeightGrid& grid, const CellParts& parts);

}  // namespace sightline::scene
