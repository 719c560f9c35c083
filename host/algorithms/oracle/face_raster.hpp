// The nearest face at every point of a raster, by a sight line for each: the reference for pictures of faces.
#pragma once

#include <cstdint>
#include <functional>

#include "host/algorithms/oracle/sight_oracle.hpp"
#include "host/picture/pixel_metrics.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::oracle {

// The sight line of the middle of a pixel, rows from the bottom.
using PixelSight = std::function<SightLine(int column, int row)>;

// Numbers of faces over all bodies (host/scene/model/poly_scene.hpp), 0 where none is met. The scene is a checked
// one, no line's direction zero (preconditions).
[[nodiscard]] picture::PixelGrid nearest_faces(const scene::PolyScene& scene, int width, int height,
                                               const PixelSight& sight);

// Square images whose pixels have whole sight lines.
struct SquareImage {
  scene::PolyCamera camera;  // its three vectors are of one length
  int size = 256;            // pixels a side
  // In perspective the distance of the image in half pixels (`size`: 90 degrees wide), else half a pixel in
  // lengths of camera vectors.
  std::int32_t unit = 256;

  // Without perspective from the plane of the eye (which is before all of the scene then: precondition).
  [[nodiscard]] SightLine sight(int column, int row) const;
};

[[nodiscard]] picture::PixelGrid nearest_faces(const scene::PolyScene& scene, const SquareImage& image);

}  // namespace sightline::algorithms::oracle
