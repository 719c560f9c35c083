// The path of a flight: from outside a scene straight through it, looking ahead.
#pragma once

#include <cstdint>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/model/aim_camera.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::programs::flight {

// The cameras of the frames. The eye passes between the buildings if a straight, level path is free at half the height of
// the lowest one; otherwise above all of them, looking down a little; with `level` (for models in plan) around them,
// looking to the middle. Error: no path lies within the scene's coordinates.
[[nodiscard]] base::Result<std::vector<scene::PolyCamera>> path_through(const scene::PolyScene& scene, const scene::SceneFrame& frame,
                                                                        std::uint32_t frames, bool level);

}  // namespace sightline::programs::flight
