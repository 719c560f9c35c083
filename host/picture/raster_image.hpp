// A raster board's picture as an image, point for point.
#pragma once

#include "emulators/core/raster.hpp"
#include "host/picture/image.hpp"

namespace sightline::picture {

enum class RasterPalette {
  colour,  // RGB: bit 2 red, bit 1 green, bit 0 blue, each full or off
  grey,    // one channel: 0 black to 7 white in equal steps
};

// 256 * scale pixels a side, every point a square of scale by scale; scale from 1 to 32.
[[nodiscard]] Image raster_image(const core::Raster& raster, RasterPalette palette, int scale);

}  // namespace sightline::picture
