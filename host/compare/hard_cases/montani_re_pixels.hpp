// Rasters of faces for Montani and Re's stripes, and the reference: the face that the exact sight line through the
// centre of each pixel meets first. Frames are chosen so that these sight lines have integer directions. Values of a
// grid: face number over all bodies + 1, 0 for none.
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
  std::vector<picture::PixelSegment> edges;  // of all faces, in the form of pixel_metrics
};

// The pixels of a view along z. A unit is `times` parts, a pixel is `pixel` parts; centres are at pixel * i + pixel /
// 2 + offset parts. These are integers, and times * coordinate < 2^18 (preconditions).
struct PixelParts {
  std::int32_t times = 1;
  std::int32_t pixel = 1;
  std::array<std::int32_t, 2> offset{};
};
// One pixel per unit: lines between stripes of a pixel are at integer ordinates, no centre is on a vertical edge.
inline constexpr PixelParts on_lines{10, 10, {3, 0}};
// 4.25 pixels per unit: no corner with integer coordinates is on the border between pixels, or in the centre of one.
inline constexpr PixelParts off_lines{34, 8, {1, 1}};

// The whole scene, seen without perspective along z with x to the right and y up (precondition).
[[nodiscard]] PixelView pixels_along_z(const scene::PolyScene& scene, const PixelParts& parts);
// In perspective, `size` pixels a side around all faces of the set, which are the scene's under its own camera.
// Pixels are square to within 1 / (4 |up| / |right|).
[[nodiscard]] PixelView pixels_in_perspective(const scene::PolyScene& scene,
                                              const algorithms::montani_re::FaceSet& set, std::int32_t size);

[[nodiscard]] picture::PixelGrid grid_of(const scene::PolyScene& scene,
                                         const algorithms::montani_re::FaceSet& set,
                                         const algorithms::montani_re::StripeRaster& raster);

// The area of stripes of `units` sixteenths of a pixel, in square pixels.
[[nodiscard]] double square_pixels(const algorithms::montani_re::StripePcs& pcs, std::int32_t units);

// The image plane of the scene's camera, in pixels. Points are before the eye (precondition).
class PixelPlane {
 public:
  PixelPlane(const scene::PolyCamera& camera, const algorithms::montani_re::StripeFrame& frame)
      : camera_(camera), frame_(frame) {}

  // The image of a point in space. Centres of pixels are at integers, as in a PixelGrid.
  [[nodiscard]] picture::PixelPoint at(const std::array<double, 3>& point) const;
  [[nodiscard]] picture::PixelSegment segment(const scene::PolyPoint& from, const scene::PolyPoint& to,
                                              double low = 0, double high = 1) const;

 private:
  scene::PolyCamera camera_;
  algorithms::montani_re::StripeFrame frame_;
};

}  // namespace sightline::compare
