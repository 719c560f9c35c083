// Makes a scene that shows a defect as small as possible, so that a person can see the cause.
//
// Solids are not rebuilt: a solid shrinks by becoming a sheet and losing faces, if the defect remains, and otherwise only by
// its coordinates.
#pragma once

#include <functional>

#include "host/scene/model/poly_scene.hpp"

namespace sightline::tests {

// Whether a scene, seen by its own camera, shows the defect. It is called only with checked scenes whose eye is in free
// space, and must always give the same answer.
using ShowsDefect = std::function<bool(const scene::PolyScene&)>;

// Preconditions: the scene is checked, its eye is in free space, and it shows the defect. The result shows it, too, and none of
// these steps makes it smaller: omitting a body, a wire, a face of a sheet, a hole or a corner; a sheet in place of a solid;
// no perspective; a camera along the axes; all coordinates halved or moved towards 0; a coordinate made smaller for one vertex,
// for all that share it, or for the eye. The result has no names, and the default units and origin.
[[nodiscard]] scene::PolyScene shrink_scene(scene::PolyScene scene, const ShowsDefect& shows_defect);

}  // namespace sightline::tests
