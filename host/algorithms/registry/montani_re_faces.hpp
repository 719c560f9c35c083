// Montani and Re's algorithm as one that fills faces: pixels by stripes of one thickness, or the outlines and
// holes of the exact regions.
#pragma once

#include <variant>

#include "host/algorithms/registry/faces.hpp"

namespace sightline::harness {

// An error if there are no stripes of this thickness.
[[nodiscard]] std::variant<PreparedFaces, scene::SceneError> prepare_montani_re_faces(
    const scene::PolyScene& scene, const FaceOptions& options);

}  // namespace sightline::harness
