// Montani and Re's algorithm for filled faces: pixels by stripes of equal thickness, or the outlines and holes of the
// exact regions.
#pragma once

#include "host/algorithms/registry/faces.hpp"
#include "host/base/result.hpp"

namespace sightline::registry {

// Returns an error if the stripe thickness is not one of stripe_thicknesses.
[[nodiscard]] base::Result<PreparedFaces> prepare_montani_re_faces(const scene::PolyScene& scene,
                                                                   const FaceOptions& options);

}  // namespace sightline::registry
