// The ideal picture of a pass: which points were lit at all, without beam, phosphor or intensity.
#pragma once

#include <span>

#include "emulators/core/stroke.hpp"
#include "host/picture/image.hpp"

namespace sightline::picture {

// 1024 x 1024 grey: 255 at column x, row 1023 - y of every stroke, else 0. Strokes off the screen light
// nothing.
[[nodiscard]] Image crisp_raster(std::span<const core::Stroke> strokes);

}  // namespace sightline::picture
