// Visible edges that bound no visible region of a face.
//
// A face through a point does not hide the point, so where a wall ends on the far side of another, in the
// midst of it, the line of contact is seen through the wall it touches; so is what a solid holds inside and
// touches its surface with. And a face of a sheet seen edge-on is a line without a region. Regions have no
// such lines: they are compared with the regions of the faces before them, one by one.
#pragma once

#include <vector>

#include "host/picture/line_picture.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::montani_re {

// Ascending. Some may be seen as a face's own edges as well. The scene is a checked one (precondition).
[[nodiscard]] std::vector<picture::LineEdge> isolated_edges(const scene::PolyScene& scene,
                                                        const scene::PolyCamera& camera);

}  // namespace sightline::algorithms::montani_re
