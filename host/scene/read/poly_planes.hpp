// Which faces of a mesh lie in one plane, as far as the numbers of its file can tell.
//
// The rounded vertices of a scene cannot tell: a face turned by any angle is in no plane any more once its
// corners are on a grid. So it is judged by the coordinates of the file. The largest face that is in no group
// yet begins one (of equal ones the first in the file); faces of the same body join it over edges that have
// two faces, as long as all their vertices are within the tolerance of the plane of that first face and they
// are turned the same way. As a small face says its plane badly far away, this is done again with the mean
// plane of the group as long as that takes in more faces, all within the tolerance of that one plane. A face
// too thin to have a direction needs the first alone. No face joins because of its neighbour: a sphere of
// many triangles stays round.
#pragma once

#include <vector>

#include "host/scene/model/poly_scene.hpp"
#include "host/scene/read/poly_mend.hpp"

namespace sightline::scene {

// Fills in scene.surfaces and scene.surface_of. `tolerance` in the unit of the file. With `jobs` threads; the result is the same.
void find_surfaces(PolyScene& scene, const MendResult& mended, const FileFaces& file, double tolerance, unsigned jobs);

}  // namespace sightline::scene
