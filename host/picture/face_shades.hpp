// Colours for the faces of a scene, and images in these colours.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host/picture/image.hpp"
#include "host/picture/pixel_metrics.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::picture {

using Shade = std::array<std::uint8_t, 3>;  // red, green, blue

// By face number over all bodies: one hue per body, lit from above and from one side.
[[nodiscard]] std::vector<Shade> face_shades(const scene::PolyScene& scene);

inline constexpr Shade sky{0xD8, 0xE6, 0xF2};
// `faces` has face numbers + 1; 0 is sky.
[[nodiscard]] Image shaded_image(const PixelGrid& faces, const std::vector<Shade>& shades);

}  // namespace sightline::picture
