// Montani and Re's algorithm in image space: stripes of equal thickness over the whole picture, one silhouette, pixels
// from the substripes. Source: Montani and Re (1985), sections 3 and 4.
//
// The thickness h determines the accuracy: corners are moved to the nearest line between stripes (their abscissa is kept,
// to 1/65536 pixel), and edges are straight between moved corners. Heights inside a stripe are counted in sixteenths of
// it. If sides cross in a stripe, it is split at the next sixteenth above, so that results are exact at whole sixteenths,
// where the pixel centres are. The error is of the order of h.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "host/algorithms/montani_re/priority.hpp"
#include "host/algorithms/montani_re/trapezoid_pcs.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::montani_re {

// Pixel coordinates are centre + scale * image coordinates, x from the left, y from below. The image's units differ in x
// and y if the camera's right and up differ in length (pixels_per_unit). A pixel belongs to the face that covers its
// centre.
struct StripeFrame {
  std::array<double, 2> scale{1, 1};
  std::array<double, 2> centre{};
  std::int32_t width = 0;
  std::int32_t height = 0;
};

// The scale of both axes for `size` pixels per unit of the image as PolyCamera defines it.
[[nodiscard]] std::array<double, 2> pixels_per_unit(const scene::PolyCamera& camera, double size);

struct StripeSide {
  std::int64_t bottom = 0;  // abscissas in 1/65536 pixel at the lower and the upper end of the stripe
  std::int64_t top = 0;

  // In 1/(16 * 65536) pixel.
  [[nodiscard]] std::int64_t at(std::int32_t sixteenths) const {
    return 16 * bottom + (top - bottom) * sixteenths;
  }
  friend bool operator==(const StripeSide&, const StripeSide&) = default;
};

// Part of a stripe, [low, high) in sixteenths, with its sides from west to east.
struct StripeBand {
  std::int32_t low = 0;
  std::int32_t high = 16;
  std::vector<StripeSide> sides;
};

// Stripes are numbered from the bottom of the frame; stripes outside the frame are omitted.
struct StripePcs {
  std::int32_t first = 0;
  std::vector<std::vector<StripeBand>> stripes;

  [[nodiscard]] std::uint64_t side_count() const;
};

// `units` sixteenths of a stripe per pixel: 2, 4, ... 64 for stripes of 8, 4, ... 1/4 pixels.
[[nodiscard]] StripePcs stripe_pcs(const Image& image, const TrapezoidPcs& region, const StripeFrame& frame,
                                   std::int32_t units);
[[nodiscard]] StripePcs combine(const StripePcs& a, const StripePcs& b, Operation operation);

struct StripeRaster {
  std::int32_t width = 0;
  std::int32_t height = 0;
  std::vector<std::uint32_t> faces;  // rows from the bottom; `none` where there is no face
  std::uint64_t sides = 0;           // of the visible regions
  std::uint64_t silhouette_sides = 0;

  friend bool operator==(const StripeRaster& a, const StripeRaster& b) { return a.faces == b.faces; }
};

// Calls `take` with the visible part of each face, front to back. Returns the silhouette of all of them.
StripePcs for_each_visible(const Image& image, const PriorityList& list, std::span<const TrapezoidPcs> listed,
                           const StripeFrame& frame, std::int32_t units,
                           const std::function<void(const StripePcs&, std::uint32_t face)>& take);

// Front to back: from every face the silhouette is subtracted, to which the face is then added.
[[nodiscard]] StripeRaster raster_by_difference(const Image& image, const PriorityList& list,
                                                std::span<const TrapezoidPcs> listed,
                                                const StripeFrame& frame, std::int32_t units);

}  // namespace sightline::algorithms::montani_re
