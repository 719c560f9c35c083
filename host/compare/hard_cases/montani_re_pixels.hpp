// Rasters of faces for Montani and Re's stripes, and the correct ones: the face met first by
// the exact sight line through the middle of each pixel. Frames are chosen so that these sight lines have
// integer directions. Values of a grid: number of the face over all bodies + 1, 0 where there is none.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host/algorithms/montani_re/faces.hpp"
#include "host/algorithms/montani_re/stripes.hpp"
#include "host/picture/pixel_metrics.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::compare {

struct PixelView {
  algorithms::montani_re::StripeFrame frame;
  picture::PixelGrid truth;
  std::vector<picture::PixelSegment> edges;  // of all faces, as pixel_metrics wants them
};

// The pixels of a view along z: of `pixel` parts of a unit, `times` parts being a unit, their middles at
// pixel * i + pixel / 2 + offset parts. Whole numbers (precondition), and times * coordinate < 2^18.
struct PixelParts {
  std::int32_t times = 1;
  std::int32_t pixel = 1;
  std::array<std::int32_t, 2> offset{};
};
// A pixel a unit: lines between stripes of a pixel are at whole ordinates, no middle on a vertical edge.
inline constexpr PixelParts on_lines{10, 10, {3, 0}};
// 4.25 pixels a unit: no corner of whole coordinates lies between two pixels, or in the middle of one.
inline constexpr PixelParts off_lines{34, 8, {1, 1}};

// All of the scene, seen without perspective along z with x to the right and y up (precondition).
[[nodiscard]] PixelView pixels_along_z(const scene::PolyScene& scene, const PixelParts& parts);
// In perspective, `size` pixels a side around all of the set's faces, which are the scene's under its own
// camera. Pixels are square to within 1 / (4 |up| / |right|) or better.
[[nodiscard]] PixelView pixels_in_perspective(const scene::PolyScene& scene,
                                              const algorithms::montani_re::FaceSet& set, std::int32_t size);

[[nodiscard]] picture::PixelGrid grid_of(const scene::PolyScene& scene,
                                         const algorithms::montani_re::FaceSet& set,
                                         const algorithms::montani_re::StripeRaster& raster);

// The area of stripes of so many sixteenths of a pixel, in square pixels.
[[nodiscard]] double square_pixels(const algorithms::montani_re::StripePcs& pcs, std::int32_t units);

// Of the image plane of the scene's camera, in pixels; nothing of what is not before the eye is asked for.
class PixelPlane {
 public:
  PixelPlane(const scene::PolyCamera& camera, const algorithms::montani_re::StripeFrame& frame)
      : camera_(camera), frame_(frame) {}

  // Of a point in space. Middles of pixels are at whole numbers, as in a PixelGrid.
  [[nodiscard]] picture::PixelPoint at(const std::array<double, 3>& point) const;
  [[nodiscard]] picture::PixelSegment segment(const scene::PolyPoint& from, const scene::PolyPoint& to,
                                              double low = 0, double high = 1) const;

 private:
  scene::PolyCamera camera_;
  algorithms::montani_re::StripeFrame frame_;
};

}  // namespace sightline::compare
