// Finer grids: what stays, what is exact, holes, limits.
#include "host/scene/heights/subdivide.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace sightline::scene {
namespace {

constexpr double hole = std::numeric_limits<double>::quiet_NaN();

template <class Function>
HeightGrid grid_of(std::vector<double> x, std::vector<double> z, Function height) {
  HeightGrid grid;
  grid.x = std::move(x);
  grid.z = std::move(z);
  for (const double at_z : grid.z)
    for (const double at_x : grid.x) grid.heights.push_back(height(at_x, at_z));
  grid.range = finite_range(grid.heights);
  return grid;
}

HeightGrid finer(const HeightGrid& grid, std::size_t parts) {
  auto result = subdivided(grid, {parts, parts});
  EXPECT_TRUE(result);
  return *result;
}

TEST(Subdivide, KeepsTheHeightsOfTheGrid) {
  std::mt19937 dice(7);
  for (int n = 0; n < 50; ++n) {
    const std::size_t points = 2 + dice() % 9;
    const std::size_t slices = 2 + dice() % 9;
    const std::size_t parts = 1 + dice() % 6;
    const HeightGrid grid = grid_of(even_positions(points), even_positions(slices), [&dice](double, double) { return static_cast<double>(dice() % 1000); });
    const HeightGrid made = finer(grid, parts);
    ASSERT_EQ(made.points(), (points - 1) * parts + 1);
    ASSERT_EQ(made.slices(), (slices - 1) * parts + 1);
    for (std::size_t s = 0; s < slices; ++s) {
      for (std::size_t p = 0; p < points; ++p) EXPECT_EQ(made.height(p * parts, s * parts), grid.height(p, s));
      EXPECT_EQ(made.z[s * parts], grid.z[s]);
    }
    EXPECT_EQ(made.range.low, std::min(grid.range.low, finite_range(made.heights).low));
    EXPECT_EQ(made.range.high, finite_range(made.heights).high);
    if (parts == 1) {
      EXPECT_EQ(made.heights, grid.heights);
    }
  }
}

// The curves of the slices do not depend on whether there are slices between them.
TEST(Subdivide, AlongOneAxisKeepsTheOtherLines) {
  std::mt19937 dice(8);
  const HeightGrid grid = grid_of(even_positions(7), even_positions(5), [&dice](double, double) { return static_cast<double>(dice() % 1000); });
  const HeightGrid both = finer(grid, 4);
  const auto along_x = subdivided(grid, {4, 1});
  const auto along_z = subdivided(grid, {1, 4});
  ASSERT_TRUE(along_x && along_z);
  ASSERT_EQ(along_x->points(), both.points());
  ASSERT_EQ(along_x->slices(), grid.slices());
  ASSERT_EQ(along_z->points(), grid.points());
  ASSERT_EQ(along_z->slices(), both.slices());
  for (std::size_t s = 0; s < grid.slices(); ++s)
    for (std::size_t p = 0; p < both.points(); ++p) EXPECT_EQ(along_x->height(p, s), both.height(p, 4 * s));
  for (std::size_t s = 0; s < both.slices(); ++s)
    for (std::size_t p = 0; p < grid.points(); ++p) EXPECT_EQ(along_z->height(p, s), both.height(4 * p, s));
}

// Also where the places are not at equal distances, and at the borders.
TEST(Subdivide, ReproducesParabolas) {
  const auto height = [](double x, double z) { return 3 - 2 * x + 5 * x * x + z * (1 - x - 4 * x * x) + z * z * (2 + x - x * x); };
  for (const std::vector<double>& x : {std::vector<double>{-1, -0.5, 0, 0.5, 1}, std::vector<double>{-1, -0.9, -0.2, 0.7, 1}, std::vector<double>{-1, 0.3, 1}}) {
    const HeightGrid made = finer(grid_of(x, {-1, -0.75, 0.125, 1}, height), 7);
    for (std::size_t s = 0; s < made.slices(); ++s)
      for (std::size_t p = 0; p < made.points(); ++p) EXPECT_NEAR(made.height(p, s), height(made.x[p], made.z[s]), 1e-13);
  }
}

// The curves have no corner at a height of the grid: from both sides the slopes approach each other.
TEST(Subdivide, HasNoCreases) {
  const HeightGrid grid = grid_of(even_positions(9), even_positions(2), [](double x, double) { return std::sin(7 * x); });
  constexpr std::size_t parts = 64;
  const HeightGrid made = finer(grid, parts);
  const double step = made.x[1] - made.x[0];
  for (std::size_t p = parts; p + parts < made.points(); p += parts) {
    const double west = (made.height(p, 0) - made.height(p - 1, 0)) / step;
    const double east = (made.height(p + 1, 0) - made.height(p, 0)) / step;
    const double corner = std::abs((grid.height(p / parts + 1, 0) - 2 * grid.height(p / parts, 0) + grid.height(p / parts - 1, 0)) / (2.0 / 8));
    EXPECT_LT(std::abs(east - west), 0.2 * corner + 0.01);
  }
}

TEST(Subdivide, HolesStayHoles) {
  HeightGrid grid = grid_of(even_positions(6), even_positions(5), [](double x, double z) { return x * x - z; });
  grid.heights[2 * 6 + 3] = hole;
  const HeightGrid made = finer(grid, 4);
  for (std::size_t s = 0; s < made.slices(); ++s) {
    for (std::size_t p = 0; p < made.points(); ++p) {
      const bool near = s > 4 && s < 12 && p > 8 && p < 16;
      EXPECT_EQ(std::isfinite(made.height(p, s)), !near) << p << ", " << s;
    }
  }
  const HeightGrid nothing = finer(grid_of(even_positions(2), even_positions(2), [](double, double) { return hole; }), 3);
  EXPECT_FALSE(anywhere_finite(nothing.heights));
}

TEST(Subdivide, ReportsATooFineGrid) {
  const HeightGrid grid = grid_of(even_positions(100), even_positions(3), [](double x, double) { return x; });
  EXPECT_TRUE(subdivided(grid, {10, 10}));
  const auto result = subdivided(grid, {11, 11});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().place, "--subdivide");
  EXPECT_NE(result.error().found.find("23 by 1090"), std::string::npos) << result.error().found;
}

}  // namespace
}  // namespace sightline::scene
