// Differences of two sets of lit points: small ones by hand, random ones compared with a search over all pairs, and the laws of
// raster_difference.hpp.
#include "host/picture/raster_difference.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "host/picture/png.hpp"

namespace sightline::picture {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

TEST(RasterDifference, OfALineAndOneShiftedAndShortened) {
  PixelGrid truth(16, 8);
  PixelGrid drawn(16, 8);
  for (int x = 2; x <= 11; ++x) truth.set(x, 3, 1);
  for (int x = 2; x <= 7; ++x) drawn.set(x, 3, 7);  // any value is lit: 8, 9, 10, 11 are missing
  drawn.set(5, 4, 1);                               // above a point of the line
  drawn.set(1, 4, 1);                               // diagonally in front of its beginning
  drawn.set(4, 6, 1);                               // 3 above it
  const RasterDifference d = raster_difference(truth, drawn);
  EXPECT_EQ(d.lit_in_truth, 10U);
  EXPECT_EQ(d.lit_in_drawn, 9U);
  // At 1, 2, 3 and 4 from (7, 3).
  EXPECT_EQ(d.missing, (DifferingPoints{4, 3, 2}));
  // At 1, 1.41 and 3.
  EXPECT_EQ(d.extra, (DifferingPoints{3, 2, 1}));
  EXPECT_DOUBLE_EQ(d.hausdorff.greatest, 4);
  EXPECT_DOUBLE_EQ(d.hausdorff.usual, 4) << "fewer than a thousand points: the greatest";
  EXPECT_FALSE(d.same());
}

TEST(RasterDifference, DistancesAreEuclidean) {
  const auto distance_of = [](int right, int up) {
    PixelGrid truth(20, 20);
    PixelGrid drawn(20, 20);
    truth.set(7, 9, 1);
    drawn.set(7 + right, 9 + up, 1);
    return raster_difference(truth, drawn);
  };
  EXPECT_DOUBLE_EQ(distance_of(3, -4).hausdorff.greatest, 5);
  EXPECT_DOUBLE_EQ(distance_of(-5, 10).hausdorff.greatest, std::sqrt(125.0));
  EXPECT_EQ(distance_of(0, 1).extra, (DifferingPoints{1, 0, 0}));
  EXPECT_EQ(distance_of(1, 1).extra, (DifferingPoints{1, 1, 0}));
  EXPECT_EQ(distance_of(-2, 0).extra, (DifferingPoints{1, 1, 0}));
  EXPECT_EQ(distance_of(2, 1).extra, (DifferingPoints{1, 1, 1}));
  EXPECT_TRUE(distance_of(0, 0).same());
}

TEST(RasterDifference, OneMovedPointOfAScreenfulIsFound) {
  PixelGrid truth(1024, 1024);
  for (int i = 0; i < 1024; ++i) {
    truth.set(i, 512, 1);
    truth.set(100, i, 1);
  }
  PixelGrid drawn = truth;
  EXPECT_TRUE(raster_difference(truth, drawn).same());
  drawn.set(700, 512, 0);
  drawn.set(700, 517, 1);
  const RasterDifference d = raster_difference(truth, drawn);
  EXPECT_EQ(d.lit_in_truth, 2047U);
  EXPECT_EQ(d.missing, (DifferingPoints{1, 0, 0})) << "its neighbours on the line are lit";
  EXPECT_EQ(d.extra, (DifferingPoints{1, 1, 1}));
  EXPECT_DOUBLE_EQ(d.hausdorff.greatest, 5);
  EXPECT_DOUBLE_EQ(d.hausdorff.usual, 0) << "one of two thousand";
}

TEST(RasterDifference, OfEmptyPictures) {
  PixelGrid something(5, 4);
  something.set(0, 0, 1);
  something.set(4, 3, 1);
  const PixelGrid nothing(5, 4);
  const RasterDifference lost = raster_difference(something, nothing);
  EXPECT_EQ(lost.missing, (DifferingPoints{2, 2, 2}));
  EXPECT_EQ(lost.hausdorff.greatest, infinite);
  EXPECT_EQ(lost.hausdorff.usual, infinite);
  const RasterDifference invented = raster_difference(nothing, something);
  EXPECT_EQ(invented.extra, (DifferingPoints{2, 2, 2}));
  EXPECT_TRUE(raster_difference(nothing, nothing).same());
  EXPECT_EQ(raster_difference(nothing, nothing).hausdorff.greatest, 0);
}

// A search over all pairs of points.
struct ByPairs {
  DifferingPoints apart;
  std::vector<double> distances;  // ascending
};

ByPairs by_pairs(const PixelGrid& from, const PixelGrid& to) {
  ByPairs found;
  for (int r = 0; r < from.height; ++r)
    for (int c = 0; c < from.width; ++c) {
      if (from.at(c, r) == 0) continue;
      double nearest = infinite;
      for (int y = 0; y < to.height; ++y)
        for (int x = 0; x < to.width; ++x)
          if (to.at(x, y) != 0) nearest = std::min(nearest, std::hypot(x - c, y - r));
      found.distances.push_back(nearest);
      found.apart.all += nearest > 0 ? 1U : 0U;
      found.apart.beyond_1 += nearest > 1.0001 ? 1U : 0U;
      found.apart.beyond_2 += nearest > 2.0001 ? 1U : 0U;
    }
  std::sort(found.distances.begin(), found.distances.end());
  return found;
}

TEST(RasterDifferenceLaws, EqualASearchOverAllPairs) {
  std::mt19937 random(5);
  for (int n = 0; n < 60; ++n) {
    const int width = 1 + static_cast<int>(random() % 24);
    const int height = 1 + static_cast<int>(random() % 24);
    PixelGrid a(width, height);
    PixelGrid b(width, height);
    const unsigned sparse_a = 2 + static_cast<unsigned>(random() % 40);
    const unsigned sparse_b = 2 + static_cast<unsigned>(random() % 40);
    for (auto& value : a.values) value = random() % sparse_a == 0 ? 3 : 0;
    for (auto& value : b.values) value = random() % sparse_b == 0 ? 1 : 0;
    const RasterDifference d = raster_difference(a, b);
    const ByPairs there = by_pairs(a, b);
    const ByPairs back = by_pairs(b, a);
    EXPECT_EQ(d.lit_in_truth, there.distances.size());
    EXPECT_EQ(d.lit_in_drawn, back.distances.size());
    EXPECT_EQ(d.missing, there.apart);
    EXPECT_EQ(d.extra, back.apart);
    double greatest = 0;
    for (const ByPairs& side : {there, back})
      if (!side.distances.empty()) greatest = std::max(greatest, side.distances.back());
    EXPECT_DOUBLE_EQ(d.hausdorff.greatest, greatest);
    EXPECT_DOUBLE_EQ(d.hausdorff.usual, greatest) << "fewer than a thousand";
    const RasterDifference exchanged = raster_difference(b, a);
    EXPECT_EQ(exchanged.missing, d.extra);
    EXPECT_EQ(exchanged.extra, d.missing);
    EXPECT_EQ(exchanged.hausdorff.greatest, d.hausdorff.greatest);
  }
}

TEST(RasterDifference, TheUsualDistanceIsExceededByOnePointInAThousand) {
  // 2,000 points of the reference; the drawing lacks four, which are 1, 2, 3 and 4 away from it.
  PixelGrid truth(2000, 1);
  for (int x = 0; x < 2000; ++x) truth.set(x, 0, 1);
  PixelGrid drawn = truth;
  for (int x = 1996; x < 2000; ++x) drawn.set(x, 0, 0);
  const RasterDifference d = raster_difference(truth, drawn);
  EXPECT_DOUBLE_EQ(d.hausdorff.greatest, 4);
  EXPECT_DOUBLE_EQ(d.hausdorff.usual, 2) << "two of 2,000 are farther";
}

TEST(RasterDifference, PictureHasAColourForEachCase) {
  PixelGrid truth(3, 2);
  PixelGrid drawn(3, 2);
  truth.set(0, 0, 1);
  drawn.set(0, 0, 1);
  truth.set(1, 0, 1);
  drawn.set(2, 1, 1);
  const Image image = difference_image(truth, drawn, 2);
  ASSERT_EQ(image.width, 6);
  ASSERT_EQ(image.height, 4);
  const auto colour = [&](int x, int y) {
    const std::size_t at = image.index(x, y);
    return Colour{image.pixels[at], image.pixels[at + 1], image.pixels[at + 2]};
  };
  EXPECT_EQ(colour(0, 3), (Colour{110, 110, 110})) << "lower left: both";
  EXPECT_EQ(colour(1, 2), (Colour{110, 110, 110}));
  EXPECT_EQ(colour(2, 2), (Colour{213, 94, 0})) << "missing";
  EXPECT_EQ(colour(5, 0), (Colour{0, 90, 200})) << "upper right: extra";
  EXPECT_EQ(colour(4, 1), (Colour{0, 90, 200}));
  EXPECT_EQ(colour(0, 0), (Colour{255, 255, 255}));
  EXPECT_EQ(colour(5, 3), (Colour{255, 255, 255}));
  EXPECT_TRUE(encode_png(image).has_value());
}

}  // namespace
}  // namespace sightline::picture
