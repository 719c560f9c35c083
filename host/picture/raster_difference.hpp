// Compares two sets of lit points of one screen: how many points of one are not in the other, and how far they are from
// it.
//
// The output of a device is a set of points: the flashes of a display, the dots of a raster, the positions of a lowered
// pen. The reference is rasterized by the device's own rule (host/compare/device_raster.hpp), so the differences are not
// caused by the device. pixel_metrics.hpp compares face numbers and counts separately near edges; overlay.hpp draws a
// difference with a title and a legend in its own units. Here only lit and dark count, distances are measured, and the
// picture has one pixel per point.
//
// The distance of a point is its Euclidean distance to the nearest lit point of the other set; adjacent points of the
// screen are 1 apart. It is computed as the square, in integers. "Beyond 1" and "beyond 2" mean greater than 1 and 2: the
// adjacent point is not beyond 1, the diagonal neighbour (1.41) is; (1, 2) away (2.24) is beyond 2, (2, 0) is not.
//
// Laws: equal sets have no differences; exchanging the sets exchanges missing and extra and does not change the
// distances; beyond 2 <= beyond 1 <= all.
#pragma once

#include <cstdint>

#include "host/picture/image.hpp"
#include "host/picture/line_metrics.hpp"
#include "host/picture/pixel_metrics.hpp"

namespace sightline::picture {

// The number of points of one set that are not in the other, and of those farther from it than 1 and than 2.
struct DifferingPoints {
  std::uint64_t all = 0;
  std::uint64_t beyond_1 = 0;
  std::uint64_t beyond_2 = 0;

  friend bool operator==(const DifferingPoints&, const DifferingPoints&) = default;
};

struct RasterDifference {
  std::uint64_t lit_in_truth = 0;
  std::uint64_t lit_in_drawn = 0;
  DifferingPoints missing;  // only in the reference
  DifferingPoints extra;    // only in the drawing
  // Over all lit points of both sets; agreeing points have distance 0. `usual` is exceeded by one point in a thousand, in
  // the worse of the two directions. Infinite if exactly one set is empty.
  HausdorffDistance hausdorff;

  [[nodiscard]] bool same() const { return missing.all == 0 && extra.all == 0; }
};

// Points that are not 0 are lit. Precondition: both have the same size.
[[nodiscard]] RasterDifference raster_difference(const PixelGrid& reference, const PixelGrid& drawn);

// The difference in three colours on white: lit in both grey, missing orange, extra blue (difference_colours). A point is
// `pixels` pixels wide and high, at least 1. Precondition: both have the same size.
[[nodiscard]] Image difference_image(const PixelGrid& reference, const PixelGrid& drawn, int pixels = 1);

}  // namespace sightline::picture
