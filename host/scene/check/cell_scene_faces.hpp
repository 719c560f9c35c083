// The part of check_scene that looks at what covers each cell face.
#pragma once

#include "host/scene/check/problems.hpp"

namespace sightline::scene {

// Precondition: all the rest of check_scene found nothing.
void check_faces(const CellScene& scene, Problems& problems);

}  // namespace sightline::scene
