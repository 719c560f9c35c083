// The path of a flight: from outside a scene straight through it, looking ahead.
#pragma once

#include <cstdint>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/model/aim_camera.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::programs::flight {

// Cameras of the frames. The eye goes between the buildings if some straight and level way is free, at half the height of the lowest one; else above
// all of them, looking down a little; and with `level` set (for models in plan) around them, looking to the middle. Errors: no way within the
// scene's coordinates.
[[nodiscard]] base::Result<std::vector<scene::PolyCamera>> path_through(const scene::PolyScene& scene, const scene::SceneFrame& frame,
                                                                        std::uint32_t frames, bool level);

}  // namespace sightline::programs::flight
