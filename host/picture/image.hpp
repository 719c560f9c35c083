// An 8-bit image in memory: one byte (grey) or three (red, green, blue) per pixel, rows from the top, no padding.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sightline::picture {

struct Colour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  friend bool operator==(const Colour&, const Colour&) = default;
};

struct Image {
  int width = 0;
  int height = 0;
  int channels = 1;  // 1 grey, 3 RGB
  std::vector<std::uint8_t> pixels;

  Image() = default;
  // A black image.
  Image(int columns, int rows, int bytes_per_pixel)
      : width(columns),
        height(rows),
        channels(bytes_per_pixel),
        pixels(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows) *
               static_cast<std::size_t>(bytes_per_pixel)) {}

  // Index of the first byte of the pixel `column` from the left, `row` from the top.
  [[nodiscard]] std::size_t index(int column, int row) const {
    return (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
            static_cast<std::size_t>(column)) *
           static_cast<std::size_t>(channels);
  }

  friend bool operator==(const Image&, const Image&) = default;
};

}  // namespace sightline::picture
