// Whether the bodies of a scene are plainly apart: each convex, and the boxes around any two without a common point. A
// cheap test that many scenes pass, so that nothing need be searched between their faces.
#pragma once

#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

// True: no plane of a face has corners of another face of the same body on both sides, and no two boxes around bodies
// meet, not even in a point. False: this does not hold, or it would take long to say (a body of very many faces, or
// bodies of very different sizes). Of a checked scene; linear in its size. With `jobs` threads; the result is the same.
[[nodiscard]] bool are_plainly_apart(const PolyScene& scene, unsigned jobs = 1);

}  // namespace sightline::scene
