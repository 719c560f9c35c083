// A raster board's picture as an image.
#pragma once

#include <span>

#include "emulators/core/raster.hpp"
#include "emulators/core/stroke.hpp"
#include "host/picture/image.hpp"

namespace sightline::picture {

enum class RasterPalette {
  colour,  // RGB: bit 2 red, bit 1 green, bit 0 blue, each full or off
  grey,    // one channel: 0 black to 7 white in equal steps
};

// 256 * scale pixels per side; every point is a square of scale by scale; scale is 1 to 32.
[[nodiscard]] Image raster_image(const core::Raster& raster, RasterPalette palette, int scale);

// The ideal picture of a pass: the points that were lit at all, without beam, phosphor or intensity.

// 1024 x 1024 grey: 255 at column x, row 1023 - y for every stroke, otherwise 0. Strokes off the screen are ignored.
[[nodiscard]] Image crisp_raster(std::span<const core::Stroke> strokes);

}  // namespace sightline::picture
