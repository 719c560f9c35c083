#include "host/algorithms/oracle/face_raster.hpp"

#include <cstddef>

#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::oracle {

picture::PixelGrid nearest_faces(const scene::PolyScene& scene, int width, int height,
                                 const PixelSight& sight) {
  const auto firsts = scene::first_face_numbers(scene);
  picture::PixelGrid grid(width, height);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const auto met = nearest_face(scene, sight(column, row));
      if (met) grid.set(column, row, firsts[met->body] + static_cast<std::uint32_t>(met->face));
    }
  }
  return grid;
}

SightLine SquareImage::sight(int column, int row) const {
  const std::int64_t x = 2 * column + 1 - size;
  const std::int64_t y = 2 * row + 1 - size;
  SightLine line{camera.eye, geometry::vector_of(camera.forward)};
  for (std::size_t a = 0; a < 3; ++a) {
    const std::int64_t aside = x * camera.right[a] + y * camera.up[a];
    if (camera.perspective) {
      line.along[a] = std::int64_t{unit} * camera.forward[a] + aside;
    } else {
      line.from[a] += static_cast<std::int32_t>(unit * aside);
    }
  }
  return line;
}

picture::PixelGrid nearest_faces(const scene::PolyScene& scene, const SquareImage& image) {
  return nearest_faces(scene, image.size, image.size,
                       [&image](int column, int row) { return image.sight(column, row); });
}

}  // namespace sightline::algorithms::oracle
