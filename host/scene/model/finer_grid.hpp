// A scene on a finer grid: for lines that end between its vertices, such as those in which faces cross and those of
// hatching. What is visible of the scene stays the same, as everything is multiplied by one whole number.
#pragma once

#include <cstdint>
#include <span>

#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

// The largest power of two by which the scene may be multiplied: its vertices keep below 2^17 and the eyes of the cameras
// below poly_coordinate_limit. At least 1.
[[nodiscard]] std::int32_t finest_factor(const PolyScene& scene, std::span<const PolyCamera> cameras);

// Multiplied by such a factor; its step is so much shorter.
[[nodiscard]] PolyScene on_finer_grid(PolyScene scene, std::int32_t factor);
[[nodiscard]] PolyCamera on_finer_grid(PolyCamera camera, std::int32_t factor);

// Of a scene without surfaces: surface_of becomes the plane of each face, in whatever body, so that lines can be drawn
// that lie on a face and that rounding has moved a little beyond it.
void number_planes(PolyScene& scene);

}  // namespace sightline::scene
