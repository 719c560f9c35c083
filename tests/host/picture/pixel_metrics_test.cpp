// Pixel mismatch: cases computed by hand, and the laws of pixel_metrics.hpp.
#include "host/picture/pixel_metrics.hpp"

#include <gtest/gtest.h>

#include <random>

namespace sightline::picture {
namespace {

TEST(PixelMetrics, CountsBoundaryAndInteriorApart) {
  PixelGrid truth(8, 4);
  PixelGrid drawn(8, 4);
  truth.set(2, 1, 5);  // missing, on the edge
  drawn.set(6, 3, 7);  // extra, far from it
  truth.set(3, 1, 5);
  drawn.set(3, 1, 6);  // another face, on the edge
  truth.set(4, 2, 5);
  drawn.set(4, 2, 5);  // equal
  // From (0, 1) to (7, 1): row 1 is its boundary, rows 0 and 2 are a pixel away.
  const PixelMetrics m = pixel_metrics(truth, drawn, {{{0, 1}, {7, 1}}});
  EXPECT_EQ(m.pixels, 32U);
  EXPECT_EQ(m.boundary_pixels, 8U);
  EXPECT_EQ(m.different_on_boundary, 2U);
  EXPECT_EQ(m.different_inside, 1U);
  EXPECT_EQ(m.lit, 3U);
  EXPECT_EQ(m.missing, 1U);
  EXPECT_EQ(m.extra, 1U);
  EXPECT_EQ(m.missing_far, 0U) << "(3, 1) is lit in both";
  EXPECT_EQ(m.extra_far, 1U);
  EXPECT_DOUBLE_EQ(m.mismatch(), 3.0 / 32);
  EXPECT_DOUBLE_EQ(m.boundary_mismatch(), 2.0 / 8);
  EXPECT_DOUBLE_EQ(m.interior_mismatch(), 1.0 / 24);
}

TEST(PixelMetrics, TheBoundaryIsThreeQuartersOfAPixelWide) {
  const PixelGrid grid(9, 9);
  const auto boundary = [&](PixelSegment edge) { return pixel_metrics(grid, grid, {edge}).boundary_pixels; };
  EXPECT_EQ(boundary({{4, 4}, {4, 4}}), 1U) << "a point";
  EXPECT_EQ(boundary({{4.5, 4.5}, {4.5, 4.5}}), 4U) << "0.71 from four middles";
  EXPECT_EQ(boundary({{4.25, 0}, {4.25, 8}}), 18U) << "0.25 and 0.75 from two columns";
  EXPECT_EQ(boundary({{4.26, 0}, {4.26, 8}}), 18U) << "0.26 and 0.74";
  EXPECT_EQ(boundary({{4.24, 0}, {4.24, 8}}), 9U) << "0.24 and 0.76";
  // The diagonal: 9 on it, and 8 on either side at 0.71.
  EXPECT_EQ(boundary({{0, 0}, {8, 8}}), 25U);
  EXPECT_EQ(boundary({{0, 8}, {8, 0}}), 25U);
  EXPECT_EQ(boundary({{-50, -3}, {50, -3}}), 0U) << "off the raster";
}

TEST(PixelMetricsLaws, Hold) {
  std::mt19937 random(3);
  const auto below = [&](unsigned limit) { return static_cast<unsigned>(random() % limit); };
  for (int n = 0; n < 20; ++n) {
    PixelGrid a(40, 30);
    PixelGrid b(40, 30);
    for (PixelGrid* grid : {&a, &b})
      for (auto& value : grid->values) value = below(3);
    std::vector<PixelSegment> edges;
    for (int e = 0; e < 5; ++e)
      edges.push_back({{1.0 * below(40), 1.0 * below(30)}, {1.0 * below(40), 1.0 * below(30)}});
    const PixelMetrics m = pixel_metrics(a, b, edges);
    const PixelMetrics exchanged = pixel_metrics(b, a, edges);
    EXPECT_EQ(exchanged.different_on_boundary, m.different_on_boundary);
    EXPECT_EQ(exchanged.different_inside, m.different_inside);
    EXPECT_EQ(exchanged.missing, m.extra);
    EXPECT_EQ(exchanged.extra, m.missing);
    EXPECT_EQ(exchanged.extra_far, m.missing_far);
    EXPECT_GT(m.different(), 0U);
    EXPECT_EQ(pixel_metrics(a, a, edges).different(), 0U);
    EXPECT_EQ(pixel_metrics(a, b, {}).different_inside, m.different()) << "no edges: everything is interior";
  }
}

}  // namespace
}  // namespace sightline::picture
