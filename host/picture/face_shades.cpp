#include "host/picture/face_shades.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "host/scene/read/poly_triangulate.hpp"

namespace sightline::picture {

namespace {

// Muted, so that brightness shows more than hue.
constexpr std::array<Shade, 7> hues{{{0xD9, 0x8C, 0x6A},
                                     {0x8F, 0xB0, 0x79},
                                     {0x7F, 0x9F, 0xC4},
                                     {0xD6, 0xBC, 0x6E},
                                     {0xA9, 0x8B, 0xBD},
                                     {0x78, 0xB5, 0xAE},
                                     {0xC7, 0x92, 0xA0}}};

double face_brightness(const std::array<std::int64_t, 3>& normal) {
  const auto x = static_cast<double>(normal[0]);
  const auto y = static_cast<double>(normal[1]);
  const auto z = static_cast<double>(normal[2]);
  const double length = std::sqrt(x * x + y * y + z * z);
  // Each of the six axis directions has a different brightness.
  return length > 0 ? 0.74 + (0.11 * x + 0.24 * y - 0.17 * z) / length : 1;
}

}  // namespace

std::vector<Shade> face_shades(const scene::PolyScene& scene) {
  std::vector<Shade> shades;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    for (const scene::PolyFace& face : scene.bodies[b].faces) {
      const double light = face_brightness(scene::ring_normal(scene.vertices, face.outline));
      Shade shade = hues[b % hues.size()];
      for (std::uint8_t& part : shade)
        part = static_cast<std::uint8_t>(std::min(255.0, std::round(part * light)));
      shades.push_back(shade);
    }
  }
  return shades;
}

Image shaded_image(const PixelGrid& faces, const std::vector<Shade>& shades) {
  Image image(faces.width, faces.height, 3);
  for (int row = 0; row < faces.height; ++row) {
    for (int column = 0; column < faces.width; ++column) {
      const std::uint32_t face = faces.at(column, row);
      const Shade& shade = face == 0 ? sky : shades[face - 1];
      std::copy(
          shade.begin(), shade.end(),
          image.pixels.begin() + static_cast<std::ptrdiff_t>(image.index(column, faces.height - 1 - row)));
    }
  }
  return image;
}

}  // namespace sightline::picture
