// Makes a scene that shows a defect as small as it gets, so that one can see by looking what it takes.
//
// Left out: rebuilding of solids. A solid becomes smaller by becoming a sheet and losing faces, if the defect
// is still there then, or else only by its coordinates.
#pragma once

#include <functional>

#include "host/scene/model/poly_scene.hpp"

namespace sightline::tests {

// Whether a scene, looked at by its own camera, shows the defect. It is asked only about checked scenes with
// the eye in free space, and must always give the same answer.
using ShowsDefect = std::function<bool(const scene::PolyScene&)>;

// The scene is a checked one, its eye in free space, and it shows the defect (preconditions). So does the
// result, and none of these steps makes it smaller: leaving out a body, a wire, a face of a sheet, a hole or a
// corner; a sheet in place of a solid; no perspective; a camera along the axes; all coordinates halved or
// moved towards 0; a coordinate made smaller for one vertex, for all that share it, or for the eye. The
// result has no names, and its units and origin are those of a scene that never was in a file.
[[nodiscard]] scene::PolyScene shrunk(scene::PolyScene scene, const ShowsDefect& shows_defect);

}  // namespace sightline::tests
