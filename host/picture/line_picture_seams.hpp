// Which edges are seams: lines where the surface one looks at does not bend, such as the diagonals of a
// triangulated face or the joint of two boxes side by side.
//
// The faces that meet in an edge part the space about it into sectors. The eye looks through one of them; the
// edge is a seam for this eye iff the faces to both sides of that sector lie in one plane. So the same edge
// may be a seam from above and a feature from below. If the eye is in the plane of one of the faces it looks
// through two sectors, and both must be flat.
//
// Faces meet in an edge iff they have it as a side, of whatever body: both ends at the same two points. Left
// out: edges of which one is only a part of the other.
#pragma once

#include "host/picture/line_picture.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::picture {

// The picture, which is one of this scene from this camera, without its seams.
[[nodiscard]] LinePicture without_seams(const LinePicture& picture, const scene::PolyScene& scene,
                                        const scene::PolyCamera& camera);

}  // namespace sightline::picture
