// The positions of grid points: exact angles, the formulas of the projection, the fit and its hard cases.
#include "host/programs/skala/projection.hpp"

#include <limits>
#include <numbers>

#include "tests/host/programs/skala/stream_support.hpp"

namespace sightline::programs::skala {
namespace {

using stream_test::grid_of;
using stream_test::named;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(SineAndCosine, ExactAtQuarterTurns) {
  for (const int turns : {-3, 0, 1, 7}) {
    const double full = 360.0 * turns;
    EXPECT_EQ(sine_and_cosine(full).sine, 0.0);
    EXPECT_EQ(sine_and_cosine(full).cosine, 1.0);
    EXPECT_EQ(sine_and_cosine(full + 90).sine, 1.0);
    EXPECT_EQ(sine_and_cosine(full + 90).cosine, 0.0);
    EXPECT_EQ(sine_and_cosine(full + 180).sine, 0.0);
    EXPECT_EQ(sine_and_cosine(full + 180).cosine, -1.0);
    EXPECT_EQ(sine_and_cosine(full + 270).sine, -1.0);
    EXPECT_EQ(sine_and_cosine(full + 270).cosine, 0.0);
  }
}

TEST(SineAndCosine, OfTheLibraryAndSymmetric) {
  for (int degrees = -400; degrees <= 400; ++degrees) {
    const auto [sine, cosine] = sine_and_cosine(degrees);
    EXPECT_NEAR(sine, std::sin(degrees * std::numbers::pi / 180), 1e-13);
    EXPECT_NEAR(cosine, std::cos(degrees * std::numbers::pi / 180), 1e-13);
    EXPECT_EQ(sine, sine_and_cosine(90 - degrees).cosine);
    EXPECT_EQ(cosine, sine_and_cosine(-degrees).cosine);
    EXPECT_EQ(sine, -sine_and_cosine(-degrees).sine);
  }
  EXPECT_EQ(sine_and_cosine(45).sine, sine_and_cosine(45).cosine);
  EXPECT_EQ(sine_and_cosine(-1e-20).cosine, 1.0);
}

TEST(RasterCoordinate, RoundsHalvesUpAndToleratesTheLastBit) {
  EXPECT_EQ(raster_coordinate(127.5), 128);
  EXPECT_EQ(raster_coordinate(std::nextafter(127.5, 0.0)), 128);
  EXPECT_EQ(raster_coordinate(127.4999), 127);
  EXPECT_EQ(raster_coordinate(-0.5), 0);
  EXPECT_EQ(raster_coordinate(-0.51), -1);
  EXPECT_EQ(raster_coordinate(254.49), 254);
  EXPECT_EQ(raster_coordinate(1e300), 1 << 20);
  EXPECT_EQ(raster_coordinate(-1e300), -(1 << 20));
}

// The formulas as published, with the library's sine and cosine.
TEST(SkalaProjection, FollowsTheFormulas) {
  const scene::HeightGrid grid = named("peaks", {9, 7});
  for (const double rotation : {0.0, 30.0, 135.0, 250.0, -20.0}) {
    for (const double elevation : {-25.0, 0.0, 35.0}) {
      const Projection projection(grid, {.rotation = rotation, .elevation = elevation});
      const double a = rotation * std::numbers::pi / 180;
      const double e = elevation * std::numbers::pi / 180;
      std::vector<double> xs;
      std::vector<double> ys;
      for (std::size_t s = 0; s < 7; ++s) {
        for (std::size_t p = 0; p < 9; ++p) {
          const double x = -1 + 2.0 * static_cast<double>(p) / 8;
          const double z = -1 + 2.0 * static_cast<double>(s) / 6;
          const double h = -1 + 2 * (grid.height(p, s) - grid.range.low) / (grid.range.high - grid.range.low);
          const double depth = -x * std::sin(a) + z * std::cos(a);
          EXPECT_NEAR(projection.at(p, s).depth, depth, 1e-12);
          xs.push_back(x * std::cos(a) + z * std::sin(a));
          ys.push_back(0.6 * h * std::cos(e) + depth * std::sin(e));
        }
      }
      const auto xr = scene::finite_range(xs);
      const auto yr = scene::finite_range(ys);
      for (std::size_t i = 0; i < xs.size(); ++i) {
        const Vertex& v = projection.at(i % 9, i / 9);
        EXPECT_NEAR(v.x, 255 * (xs[i] - xr.low) / (xr.high - xr.low), 1e-9);
        EXPECT_NEAR(v.y, 255 * (ys[i] - yr.low) / (yr.high - yr.low), 1e-9);
        EXPECT_NEAR(v.column, v.x, 0.5 + 1e-6);
        EXPECT_NEAR(v.row, v.y, 0.5 + 1e-6);
      }
    }
  }
}

TEST(SkalaProjection, ZeroExtentIsAt128) {
  const Projection flat(named("flat", {5, 4}), {.elevation = 0, .zoom = 3});
  EXPECT_EQ(flat.at(2, 2).row, 128);
  const Projection one(grid_of({{7.0}}), {.rotation = 33});
  EXPECT_EQ(one.at(0, 0).column, 128);
  EXPECT_EQ(one.at(0, 0).row, 128);
  // One slice seen along itself.
  const Projection end_on(grid_of({{0.0, 1.0, 2.0}}), {.rotation = 90});
  for (std::size_t p = 0; p < 3; ++p) EXPECT_EQ(end_on.at(p, 0).column, 128);
}

TEST(SkalaProjection, UndefinedHeightsDoNotScaleThePicture) {
  // The left column and the far row are undefined everywhere.
  const Projection projection(grid_of({{nan, 0, 1, 0}, {nan, 1, 0, 1}, {nan, nan, nan, nan}}), {});
  EXPECT_FALSE(projection.at(0, 0).defined);
  EXPECT_LT(projection.at(0, 0).column, 0);
  EXPECT_EQ(projection.at(1, 0).column, 0);
  EXPECT_EQ(projection.at(3, 1).column, 255);
  EXPECT_EQ(projection.at(1, 0).row, 0);
  EXPECT_EQ(projection.at(3, 1).row, 255);
  const Projection huge(grid_of({{-1.7e308, 1.7e308}, {0, HUGE_VAL}}), {.elevation = 0});
  EXPECT_EQ(huge.at(0, 0).row, 0);
  EXPECT_EQ(huge.at(1, 0).row, 255);
  EXPECT_EQ(huge.at(0, 1).row, 128);
  EXPECT_FALSE(huge.at(1, 1).defined);
}

TEST(SkalaProjection, ZoomEnlargesAboutTheMiddle) {
  const scene::HeightGrid grid = named("gauss", {9, 9});
  const Projection plain(grid, {.rotation = 20});
  const Projection zoomed(grid, {.rotation = 20, .zoom = 2});
  for (std::size_t i = 0; i < 81; ++i) {
    EXPECT_NEAR(zoomed.at(i % 9, i / 9).x - 127.5, 2 * (plain.at(i % 9, i / 9).x - 127.5), 1e-9);
    EXPECT_NEAR(zoomed.at(i % 9, i / 9).y - 127.5, 2 * (plain.at(i % 9, i / 9).y - 127.5), 1e-9);
  }
}

TEST(SkalaProjection, TurningTheDataAndTheEyeTogetherChangesNothing) {
  for (const char* name : {"peaks", "terrain", "rosen"}) {
    const scene::HeightGrid grid = named(name, {11, 8});
    const scene::HeightGrid turned = stream_test::rotate_grid(grid);
    for (int rotation = -180; rotation <= 360; rotation += 5) {
      const Projection one(grid, {.rotation = 1.0 * rotation});
      const Projection other(turned, {.rotation = rotation - 90.0});
      for (std::size_t p = 0; p < 11; ++p) {
        for (std::size_t s = 0; s < 8; ++s) {
          const Vertex& a = one.at(p, s);
          const Vertex& b = other.at(s, 10 - p);
          ASSERT_EQ(a.x, b.x);
          ASSERT_EQ(a.y, b.y);
          ASSERT_EQ(a.depth, b.depth);
        }
      }
    }
  }
}

}  // namespace
}  // namespace sightline::programs::skala
