// Montani and Re's algorithm as one that fills faces: pixels by stripes of one thickness, or the outlines and
// holes of the exact regions.
#pragma once

#include "host/algorithms/registry/faces.hpp"
#include "host/base/result.hpp"

namespace sightline::registry {

// An error if there are no stripes of this thickness.
[[nodiscard]] base::Result<PreparedFaces> prepare_montani_re_faces(const scene::PolyScene& scene,
                                                                   const FaceOptions& options);

}  // namespace sightline::registry
