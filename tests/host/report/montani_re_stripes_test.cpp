// Montani and Re's stripes: the measures know a rectangle, and errors fall with the thickness.
#include "host/report/experiments/montani_re_stripes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host/report/experiments/montani_re_growth.hpp"
#include "host/compare/hard_cases/montani_re_pixels.hpp"

namespace sightline::report {
namespace {

TEST(MontaniReGrowth, ExponentsOfPowersAreTheirs) {
  EXPECT_NEAR(growth_exponent({{1, 5}, {10, 50 * std::sqrt(10)}, {100, 5000}}), 1.5, 1e-12);
  EXPECT_EQ(growth_exponent({{1, 5}}), 0);
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
  EXPECT_EQ(boundary.size(), 6U) << "two sides a stripe, one below, one above";
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

TEST(MontaniReStripes, ErrorFallsWithThicknessAndIsNothingForTheExactBuild) {
  // Nothing in it is lower than half a stripe: that would be lost.
  const Records records =
      measure_stripes({.scenes = {"boxes"}, .scene_size = 8, .raster = 128, .rounds = 0}, {});
  const RowSet& rows = records.at("stripes");
  ASSERT_EQ(rows.size(), 7U);
  const auto at = [&rows](std::size_t row, std::string_view key) {
    return rows.at(row, key).number().value();
  };
  for (std::size_t row = 0; row < 6; ++row) {
    EXPECT_GT(at(row, "true_length_px"), 500);
    EXPECT_GT(at(row, "h_usual_stripes"), 0.1) << row;
    EXPECT_LT(at(row, "h_usual_px"), 0.5 * at(row, "thickness_px") + 0.01) << row;
    if (at(row, "thickness_px") > 1) continue;
    EXPECT_EQ(at(row, "pmr_inside_percent"), 0) << row;
    EXPECT_EQ(at(row, "l_sym_percent"), 0) << row;
  }
  EXPECT_GT(at(0, "l_sym_percent"), 1);
  EXPECT_GT(at(0, "pmr_percent"), 8 * at(5, "pmr_percent"));
  EXPECT_NEAR(at(5, "sides") / at(4, "sides"), 2, 0.1);
  EXPECT_TRUE(rows.at(6, "thickness_px").missing());
  EXPECT_EQ(at(6, "pmr_percent"), 0);
  EXPECT_LT(at(6, "h_px"), 1e-6);
}

}  // namespace
}  // namespace sightline::report
