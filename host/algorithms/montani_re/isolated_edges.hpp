// Visible edges that bound no visible region of a face.
//
// A face through a point does not hide the point. Therefore the line where a wall ends on the far side of another wall,
// away from its edges, is seen through the wall that it touches; so is a line in which something inside a solid touches
// the solid's surface. A face of a sheet seen edge-on is a line without a region. No region is bounded by such edges:
// they are compared one by one with the regions of the faces before them.
#pragma once

#include <vector>

#include "host/picture/line_picture.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::montani_re {

// Ascending. An isolated edge may also be visible as a face's own edge. Precondition: the scene is checked.
[[nodiscard]] std::vector<picture::LineEdge> isolated_edges(const scene::PolyScene& scene,
                                                        const scene::PolyCamera& camera);

}  // namespace sightline::algorithms::montani_re
