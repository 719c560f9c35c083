// Which cell is a point in?
#pragma once

#include <cstddef>

#include "host/base/result.hpp"
#include "host/scene/model/cell_scene.hpp"

namespace sightline::scene {

// The number of the cell whose closed box contains the point. Where several do: if the point is in an opening
// (closed), the lower-numbered of the two cells of the lowest-numbered such opening; else, on an opaque face,
// the lowest-numbered cell on the side looked into (+z). An error if the point is in a solid or outside
// everything.
[[nodiscard]] base::Result<std::size_t> locate(const CellScene& scene, const geometry::Point& point);

}  // namespace sightline::scene
