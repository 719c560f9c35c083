#include "host/picture/raster_image.hpp"

#include <algorithm>
#include <array>

#include "host/picture/stroke_recorders.hpp"

namespace sightline::picture {

namespace {

using Pixel = std::array<std::uint8_t, 3>;

Pixel pixel_of(unsigned value, RasterPalette palette) {
  if (palette == RasterPalette::grey) {
    const auto grey = static_cast<std::uint8_t>((value * 255 + 3) / 7);
    return {grey, grey, grey};
  }
  const auto plane = [value](unsigned bit) {
    return static_cast<std::uint8_t>((value & bit) != 0 ? 255 : 0);
  };
  return {plane(4), plane(2), plane(1)};
}

}  // namespace

Image raster_image(const core::Raster& raster, RasterPalette palette, int scale) {
  const int channels = palette == RasterPalette::colour ? 3 : 1;
  Image image(core::Raster::width * scale, core::Raster::height * scale, channels);
  for (int row = 0; row < core::Raster::height; ++row) {
    const auto points = raster.row(static_cast<std::uint8_t>(core::Raster::height - 1 - row));
    auto to = image.pixels.begin() + static_cast<std::ptrdiff_t>(image.index(0, row * scale));
    const auto first_line = to;
    for (const std::uint8_t value : points) {
      const Pixel pixel = pixel_of(value, palette);
      for (int n = 0; n < scale; ++n) to = std::copy_n(pixel.begin(), channels, to);
    }
    const auto length = to - first_line;
    for (int n = 1; n < scale; ++n) to = std::copy_n(first_line, length, to);
  }
  return image;
}

Image crisp_raster(std::span<const core::Stroke> strokes) {
  Image image(screen_points, screen_points, 1);
  for (const core::Stroke& stroke : strokes) {
    if (on_screen(stroke)) image.pixels[image.index(stroke.x, screen_points - 1 - stroke.y)] = 255;
  }
  return image;
}

}  // namespace sightline::picture
