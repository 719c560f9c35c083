// Two sets of lit points of one screen compared: how many of the one are not in the other, and how far away the other is.
//
// What a device shows is a set of points: the flashes of a display, the dots of a raster, the places of a pen that is
// down. The truth is rasterized by the device's own rule (host/compare/device_raster.hpp), so what differs here is no
// matter of the device. pixel_metrics.hpp compares numbers of faces, and counts apart near edges; overlay.hpp draws a
// difference with a title and a legend in units of its own; here only lit and dark count, distances are measured, and
// the picture has a pixel a point.
//
// The distance of a point is the Euclidean one to the nearest lit point of the other set, points of the screen being
// 1 apart; it is found in whole numbers, squared. "Beyond 1" and "beyond 2" are greater than 1 and 2: the point beside is
// not beyond 1, the one beside diagonally (1.41) is; (1, 2) away (2.24) is beyond 2, (2, 0) is not.
//
// Laws: equal sets differ by nothing; exchanging them exchanges missing and extra and leaves the distances as they are;
// beyond 2 <= beyond 1 <= all.
#pragma once

#include <cstdint>

#include "host/picture/image.hpp"
#include "host/picture/line_metrics.hpp"
#include "host/picture/pixel_metrics.hpp"

namespace sightline::picture {

// Points of one set that are not in the other, and of these the ones whose distance from it is greater than 1 and than 2.
struct PointsApart {
  std::uint64_t all = 0;
  std::uint64_t beyond_1 = 0;
  std::uint64_t beyond_2 = 0;

  friend bool operator==(const PointsApart&, const PointsApart&) = default;
};

struct RasterDifference {
  std::uint64_t lit_in_truth = 0;
  std::uint64_t lit_in_drawn = 0;
  PointsApart missing;  // in the truth only
  PointsApart extra;    // in the drawing only
  // Over all lit points of both, those that agree at distance 0; `usual` is exceeded by one point in a thousand, in the
  // worse of the two directions. Infinite if one set is empty and the other not.
  HausdorffDistance hausdorff;

  [[nodiscard]] bool same() const { return missing.all == 0 && extra.all == 0; }
};

// What is not 0 is lit. Both of the same size (precondition).
[[nodiscard]] RasterDifference raster_difference(const PixelGrid& truth, const PixelGrid& drawn);

// The difference in three colours on white, a point being `pixels` pixels wide and high, at least 1: lit in both grey,
// missing orange, extra blue (difference_colours). Both of the same size (precondition).
[[nodiscard]] Image difference_image(const PixelGrid& truth, const PixelGrid& drawn, int pixels = 1);

}  // namespace sightline::picture
