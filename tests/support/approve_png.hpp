// Approved pictures: PNG files compared byte for byte; a mismatch also writes a picture of the difference.
// Link sightline_picture to use it.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>

#include "host/picture/image.hpp"
#include "host/picture/png.hpp"
#include "tests/support/approve.hpp"

namespace sightline::tests {

struct PictureDifference {
  picture::Image image;  // RGB: equal pixels white, missing red, extra green, on black
  long missing = 0;      // pixels darker than approved, or beyond the received picture
  long extra = 0;        // pixels lighter than approved (or of another hue), or beyond the approved picture
};

namespace detail {

// Sum of a pixel's bytes, and the bytes themselves; -1 beyond the picture.
struct Pixel {
  int sum = -1;
  std::array<std::uint8_t, 3> bytes{};
};

inline Pixel pixel_at(const picture::Image& image, int column, int row) {
  Pixel pixel;
  if (column >= image.width || row >= image.height) return pixel;
  pixel.sum = 0;
  for (int channel = 0; channel < 3; ++channel) {
    const int stored = std::min(channel, image.channels - 1);
    pixel.bytes[static_cast<std::size_t>(channel)] =
        image.pixels[image.index(column, row) + static_cast<std::size_t>(stored)];
    pixel.sum += pixel.bytes[static_cast<std::size_t>(channel)];
  }
  return pixel;
}

}  // namespace detail

inline PictureDifference picture_difference(const picture::Image& approved, const picture::Image& received) {
  PictureDifference difference;
  difference.image =
      picture::Image(std::max(approved.width, received.width), std::max(approved.height, received.height), 3);
  for (int row = 0; row < difference.image.height; ++row) {
    for (int column = 0; column < difference.image.width; ++column) {
      const auto a = detail::pixel_at(approved, column, row);
      const auto r = detail::pixel_at(received, column, row);
      std::array<std::uint8_t, 3> shown = a.bytes;
      if (r.sum < a.sum) {
        ++difference.missing;
        shown = {255, 0, 0};
      } else if (r.sum > a.sum || r.bytes != a.bytes) {
        ++difference.extra;
        shown = {0, 255, 0};
      }
      std::copy(
          shown.begin(), shown.end(),
          difference.image.pixels.begin() + static_cast<std::ptrdiff_t>(difference.image.index(column, row)));
    }
  }
  return difference;
}

// `name` is a path below tests/data/approved ending in ".png".
inline testing::AssertionResult matches_approved_png(const picture::Image& received,
                                                     const std::string& name) {
  const auto bytes = picture::encode_png(received);
  if (!bytes) return testing::AssertionFailure() << bytes.error().message();
  auto verdict = matches_approved(*bytes, name);
  if (verdict) return verdict;
  const auto approved = picture::read_png(approved_path(name).string());
  if (!approved) return verdict << "\n  no difference picture: " << approved.error().message();
  if (approved->image == received) return verdict << "\n  every pixel agrees: only the compression differs";
  const auto difference = picture_difference(approved->image, received);
  const std::string path = received_path(name + ".difference.png").string();
  const auto written = picture::write_png(path, difference.image);
  return verdict << "\n  " << difference.missing << " pixels missing (red), " << difference.extra
                 << " extra (green)\n  difference: " << (written ? path : written.error().message());
}

}  // namespace sightline::tests
