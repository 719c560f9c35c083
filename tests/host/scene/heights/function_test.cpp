// Functions by name: their table, values known from their formulas, sampling and range.
#include "host/scene/heights/function.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace sightline::scene {
namespace {

double value(std::string_view name, double x, double z) {
  return height_function(name)->value(x, z);
}

TEST(HeightFunctions, TheEightComeFirst) {
  EXPECT_EQ(height_function_names(),
            "sinc, rogers, peaks, franke, saddle, cosr, step, rosen, flat, spike, gauss, terrain");
  EXPECT_EQ(height_functions()[figure_functions].name, "flat");
  EXPECT_FALSE(height_function("sinc "));
  EXPECT_FALSE(height_function(""));
  EXPECT_EQ(height_function("cosr")->domain, (Interval{-12, 12}));
  EXPECT_EQ(height_function("rogers")->domain, (Interval{0, 2 * std::numbers::pi}));
}

// Points where the formulas can be computed by hand.
TEST(HeightFunctions, KnownValues) {
  EXPECT_EQ(value("sinc", 0, 0), 1.0);
  EXPECT_NEAR(value("sinc", 3, 4), std::sin(5.0) / 5, 1e-15);
  EXPECT_NEAR(value("rogers", std::numbers::pi, std::numbers::pi), -1.5, 1e-12);
  EXPECT_NEAR(value("peaks", 0, 0), 3 / std::numbers::e - 1 / (3 * std::numbers::e), 1e-12);
  EXPECT_NEAR(value("peaks", 1, 0), 8.0 / std::numbers::e - std::exp(-4) / 3, 1e-12);
  EXPECT_NEAR(value("franke", 2.0 / 9, 2.0 / 9),
              0.75 + 0.75 * std::exp(-9.0 / 49 - 0.3) + 0.5 * std::exp(-6.5) - 0.2 * std::exp(-29), 1e-12);
  EXPECT_EQ(value("saddle", 0.5, -0.5), -0.25);
  EXPECT_NEAR(value("cosr", 3, 4), std::cos(5.0), 1e-15);
  EXPECT_EQ(value("step", 0.6, 0.7), 1.0);
  EXPECT_EQ(value("step", 0, 1), 0.0);
  EXPECT_EQ(value("rosen", 1, 1), 0.0);
  EXPECT_NEAR(value("rosen", 0, 1), std::log(102.0), 1e-15);
  EXPECT_NEAR(value("gauss", 1, 1), std::exp(-2), 1e-15);
}

TEST(EvenPositions, AreSymmetric) {
  EXPECT_EQ(even_positions(1), (std::vector<double>{0}));
  EXPECT_EQ(even_positions(5), (std::vector<double>{-1, -0.5, 0, 0.5, 1}));
  const auto positions = even_positions(34);
  for (std::size_t i = 0; i < 34; ++i) EXPECT_EQ(positions[i], -positions[33 - i]);
}

TEST(Sample, CoversTheDomainSliceBySlice) {
  const HeightGrid grid = sample(*height_function("saddle"), {5, 3});
  EXPECT_EQ(grid.points(), 5U);
  EXPECT_EQ(grid.slices(), 3U);
  const std::vector<double> expected{1, 0.5, 0, -0.5, -1, 0, 0, 0, 0, 0, -1, -0.5, 0, 0.5, 1};
  EXPECT_EQ(grid.heights, expected);
  EXPECT_EQ(grid.height(3, 2), 0.5);
  const HeightGrid rogers = sample(*height_function("rogers"), {3, 3});
  EXPECT_NEAR(rogers.height(1, 1), -1.5, 1e-12);
  EXPECT_EQ(rogers.domain_x.low, 0);
}

// The range is that of 65 x 65 points: 2 x 2 of the bell would contain only the corners.
TEST(Sample, RangeDoesNotDependOnTheSize) {
  for (const HeightFunction& f : height_functions()) {
    if (f.value == nullptr) continue;
    EXPECT_EQ(sample(f, {2, 2}).range, sample(f, {65, 65}).range) << f.name;
    EXPECT_EQ(sample(f, {65, 65}).range, finite_range(sample(f, {65, 65}).heights)) << f.name;
  }
  EXPECT_EQ(sample(*height_function("gauss"), {2, 2}).range.high, 1.0);
}

TEST(Sample, SpikeAndTerrainBelongToTheGrid) {
  const HeightGrid spike = sample(*height_function("spike"), {6, 5});
  double sum = 0;
  for (const double h : spike.heights) sum += h;
  EXPECT_EQ(sum, 1.0);
  EXPECT_EQ(spike.height(3, 2), 1.0);
  EXPECT_EQ(spike.range, (Interval{0, 1}));
  const HeightGrid terrain = sample(*height_function("terrain"), {16, 10});
  EXPECT_EQ(terrain.height(0, 0), 0);
  EXPECT_EQ(terrain.height(1, 0), 27);                          // 91 mod 64
  EXPECT_EQ(terrain.height(0, 5), 57);                          // 185 mod 64
  EXPECT_EQ(terrain.height(0, 6), 30 + 40);                     // 222 mod 64
  EXPECT_EQ(terrain.height(10, 6), (222 + 910 + 7) % 64 + 40);  // 60 mod 53 = 7
}

TEST(FiniteRange, OmitsUndefinedHeights) {
  EXPECT_EQ(finite_range({NAN, 3, -HUGE_VAL, -2, HUGE_VAL}), (Interval{-2, 3}));
  EXPECT_EQ(finite_range({NAN}), (Interval{0, 0}));
  EXPECT_FALSE(anywhere_finite({NAN, HUGE_VAL}));
  EXPECT_TRUE(anywhere_finite({NAN, 0}));
}

}  // namespace
}  // namespace sightline::scene
