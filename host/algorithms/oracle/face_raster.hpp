// Finds the nearest face at every point of a raster with one sight line each: the reference for pictures of faces.
#pragma once

#include <cstdint>
#include <functional>

#include "host/algorithms/oracle/sight_oracle.hpp"
#include "host/picture/pixel_metrics.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::oracle {

// The sight line of the centre of a pixel; rows count from the bottom.
using PixelSight = std::function<SightLine(int column, int row)>;

// Returns numbers of faces over all bodies (host/scene/model/poly_scene.hpp), 0 where the sight line meets none.
// Preconditions: the scene is checked, no line has the direction zero.
[[nodiscard]] picture::PixelGrid nearest_faces(const scene::PolyScene& scene, int width, int height,
                                               const PixelSight& sight);

// A square image whose pixels have integer sight lines.
struct SquareImage {
  scene::PolyCamera camera;  // its three vectors have equal lengths
  int size = 256;            // pixels per side
  // In perspective, the distance of the image in half pixels (`size`: 90 degrees wide); otherwise the length of half a
  // pixel in lengths of camera vectors.
  std::int32_t unit = 256;

  // In orthographic views the line starts in the plane of the eye. Precondition: all of the scene is before that plane.
  [[nodiscard]] SightLine sight(int column, int row) const;
};

[[nodiscard]] picture::PixelGrid nearest_faces(const scene::PolyScene& scene, const SquareImage& image);

}  // namespace sightline::algorithms::oracle
