// A raster board's picture as an image: colours by plane, greys in equal steps, the bottom row at the bottom.
#include "host/picture/raster_image.hpp"

#include <gtest/gtest.h>

#include <array>
#include <memory>

namespace sightline::picture {
namespace {

std::unique_ptr<core::Raster> all_colours() {
  auto raster = std::make_unique<core::Raster>();
  for (int x = 0; x < 256; ++x)
    for (int y = 0; y < 256; ++y)
      raster->set(static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y),
                  static_cast<std::uint8_t>((x + 3 * y) % 8));
  return raster;
}

TEST(RasterImage, EveryPixelIsItsPoint) {
  const auto raster = all_colours();
  constexpr std::array<std::array<int, 3>, 8> colours{{{0, 0, 0},
                                                       {0, 0, 255},
                                                       {0, 255, 0},
                                                       {0, 255, 255},
                                                       {255, 0, 0},
                                                       {255, 0, 255},
                                                       {255, 255, 0},
                                                       {255, 255, 255}}};
  constexpr std::array<int, 8> greys{0, 36, 73, 109, 146, 182, 219, 255};
  for (const int scale : {1, 2, 3}) {
    const Image colour = raster_image(*raster, RasterPalette::colour, scale);
    const Image grey = raster_image(*raster, RasterPalette::grey, scale);
    ASSERT_EQ(colour.channels, 3);
    ASSERT_EQ(grey.channels, 1);
    ASSERT_EQ(colour.width, 256 * scale);
    ASSERT_EQ(grey.height, 256 * scale);
    ASSERT_EQ(colour.pixels.size(), grey.pixels.size() * 3);
    for (int row = 0; row < grey.height; ++row) {
      for (int column = 0; column < grey.width; ++column) {
        const auto value = static_cast<std::size_t>((column / scale + 3 * (255 - row / scale)) % 8);
        ASSERT_EQ(grey.pixels[grey.index(column, row)], greys[value]);
        for (std::size_t plane = 0; plane < 3; ++plane)
          ASSERT_EQ(colour.pixels[colour.index(column, row) + plane], colours[value][plane]);
      }
    }
  }
}

}  // namespace
}  // namespace sightline::picture
