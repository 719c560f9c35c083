// From scattered points to a grid of heights: linear on the triangles of their Delaunay triangulation.
#pragma once

#include <string_view>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::scene {

struct ScatteredPoint {
  double x = 0;
  double y = 0;  // our z
  double height = 0;
};

// The grid of this size over the box around the points, all of which are finite; a place outside of their convex hull is a hole. The
// triangulation is that of the points rounded to 1/2^17 of the box; of several points in one place the first one counts. The note says
// how many points and holes there are. The range is not set. The error: fewer than three places, or all of them on a line.
[[nodiscard]] base::Result<HeightGrid> interpolated(const std::vector<ScatteredPoint>& points, GridSize size,
                                                    std::string_view source);

}  // namespace sightline::scene
