// Montani and Re's stripes: the measures of a rectangle, and errors that decrease with the thickness.
#include "host/report/experiments/montani_re_stripes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host/report/experiments/montani_re_growth.hpp"
#include "host/compare/hard_cases/montani_re_pixels.hpp"

namespace sightline::report {
namespace {

TEST(MontaniReGrowth, ExponentsOfPowersAreTheirs) {
  EXPECT_NEAR(growth_exponent({{1, 5}, {10, 50 * std::sqrt(10)}, {100, 5000}}, 3).value(), 1.5, 1e-12);
}

TEST(MontaniReGrowth, FewPointsHaveNoExponent) {
  EXPECT_FALSE(growth_exponent({{1, 5}}, 2));
  EXPECT_FALSE(growth_exponent({{1, 5}, {10, 0}, {100, 0}}, 2)) << "points of 0 are omitted";
  EXPECT_NEAR(growth_exponent({{1, 5}, {10, 0}, {100, 500}}, 2).value(), 1, 1e-12);
}

TEST(MontaniReStripes, TheBoundaryOfARectangleIsItsSides) {
  using algorithms::montani_re::StripeBand;
  using algorithms::montani_re::StripePcs;
  // From x = 2 to 5, y = 3 to 5, in stripes of a pixel.
  constexpr std::int64_t pixel = 65536;
  const StripeBand band{0, 16, {{2 * pixel, 2 * pixel}, {5 * pixel, 5 * pixel}}};
  StripePcs pcs{3, {{band}, {band}}};
  EXPECT_DOUBLE_EQ(compare::square_pixels(pcs, 16), 6);
  double length = 0;
  double lowest = 1e9;
  const auto boundary = boundary_of(pcs, 16);
  EXPECT_EQ(boundary.size(), 6U) << "two sides per stripe, one below, one above";
  for (const picture::PixelSegment& s : boundary) {
    length += std::hypot(s.b.x - s.a.x, s.b.y - s.a.y);
    lowest = std::min({lowest, s.a.y, s.b.y});
  }
  EXPECT_DOUBLE_EQ(length, 10);
  EXPECT_DOUBLE_EQ(lowest, 2.5) << "middles of pixels are at whole numbers";
  // A hole in the upper stripe: its sides, and its lower end.
  pcs.stripes[1][0].sides = {
      {2 * pixel, 2 * pixel}, {3 * pixel, 3 * pixel}, {4 * pixel, 4 * pixel}, {5 * pixel, 5 * pixel}};
  EXPECT_EQ(boundary_of(pcs, 16).size(), 2U + 1 + 4 + 1 + 2);
}

TEST(MontaniReStripes, ErrorFallsWithThicknessAndIsZeroForTheExactBuild) {
  // Nothing in it is lower than half a stripe, which would be lost.
  const auto measured = measure_stripes({.scenes = {"boxes"}, .scene_size = 8, .raster = 128, .rounds = 0}, {});
  const std::vector<StripesPicture>& pictures = measured.pictures;
  ASSERT_EQ(pictures.size(), stripe_units.size() + 1);
  for (std::size_t i = 0; i < stripe_units.size(); ++i) {
    const StripesPicture& p = pictures[i];
    ASSERT_TRUE(p.in_stripes());
    EXPECT_GT(p.true_length_px, 500);
    EXPECT_GT(p.h_usual_stripes().value(), 0.1) << i;
    EXPECT_LT(p.h_usual_px, 0.5 * *p.thickness_px + 0.01) << i;
    if (*p.thickness_px > 1) continue;
    EXPECT_EQ(p.pmr_inside_percent, 0) << i;
    EXPECT_EQ(p.l_sym_percent, 0) << i;
  }
  EXPECT_GT(pictures[0].l_sym_percent, 1);
  EXPECT_GT(pictures[0].pmr_percent, 8 * pictures[5].pmr_percent);
  EXPECT_NEAR(static_cast<double>(pictures[5].sides) / static_cast<double>(pictures[4].sides), 2, 0.1);
  const StripesPicture& exact = pictures.back();
  EXPECT_FALSE(exact.in_stripes());
  EXPECT_FALSE(exact.h_usual_stripes());
  EXPECT_EQ(exact.pmr_percent, 0);
  EXPECT_LT(exact.h_px, 1e-6);
  EXPECT_FALSE(exact.view_ms) << "no times were requested";
  ASSERT_EQ(measured.exponents.size(), 1U);
  EXPECT_NEAR(measured.exponents[0].sides.value(), -1, 0.1) << "half the thickness, twice the sides";
  EXPECT_FALSE(measured.exponents[0].view_ms);
}

}  // namespace
}  // namespace sightline::report
