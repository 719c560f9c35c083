// Accuracy against time: the references of pictures, and the measures on pictures with a known error.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "host/compare/jones_precision/study.hpp"
#include "host/report/experiments/clock.hpp"
#include "host/report/experiments/jones_pictures.hpp"
#include "host/report/experiments/surface_error.hpp"

namespace sightline::report {
namespace {

TEST(ReportClock, EveryRoundDoesEveryJobOnce) {
  std::string done;
  const std::vector<std::function<void()>> jobs{[&] { done += 'a'; }, [&] { done += 'b'; }};
  const auto times = median_nanoseconds(jobs, 3);
  EXPECT_EQ(done, "abababab") << "three rounds after an uncounted one";
  ASSERT_EQ(times.size(), 2U);
  EXPECT_GE(times[0], 0);
}

picture::VectorDrawing line(float x0, float y0, float x1, float y1) {
  picture::VectorDrawing drawing;
  drawing.width = drawing.height = 255;
  drawing.layers = {{"lines", {}}};
  drawing.points = {{x0, y0}, {x1, y1}};
  drawing.lines = {{0, 0, 2}};
  return drawing;
}

std::size_t lit(const picture::PixelGrid& grid) {
  std::size_t count = 0;
  for (const std::uint32_t value : grid.values) count += value;
  return count;
}

TEST(SurfaceErrors, ALineHasADotAColumnOrARow) {
  const auto level = dots_of(line(10, 20, 200, 20), 256);
  EXPECT_EQ(lit(level), 191U);
  EXPECT_EQ(level.at(10, 20), 1U);
  EXPECT_EQ(level.at(200, 20), 1U);
  EXPECT_EQ(dots_of(line(30, 5, 31, 104), 256).at(30, 5), 1U);
  EXPECT_EQ(lit(dots_of(line(30, 5, 31, 104), 256)), 100U);
  EXPECT_EQ(lit(dots_of(line(0, 0, 255, 255), 64)), 64U);
}

TEST(SurfaceErrors, FewerDotsAreTheMiddleOfTheBoard) {
  core::Raster board;
  board.set(96, 96, 7);
  board.set(159, 159, 1);
  board.set(95, 100, 1);
  const auto dots = dots_of(board, 64);
  EXPECT_EQ(lit(dots), 2U);
  EXPECT_EQ(dots.at(0, 0), 1U);
  EXPECT_EQ(dots.at(63, 63), 1U);
}

TEST(SurfaceErrors, OneUnitIsFourPixels) {
  const FinePicture fine(line(10, 20, 200, 20));
  const auto none = fine.error_of(line(10, 20, 200, 20), 256);
  EXPECT_EQ(none.mismatch, 0);
  EXPECT_LT(none.hausdorff, 1e-9);
  const auto above = fine.error_of(line(10, 21, 200, 21), 256);
  EXPECT_NEAR(above.hausdorff, 4, 1e-9);
  EXPECT_NEAR(above.mismatch, 100 * 2 * 191.0 / 65536, 1e-9);
  EXPECT_EQ(above.far, 0) << "each dot has one of the other picture next to it";
  const auto shorter = fine.error_of(line(10, 20, 180, 20), 256);
  EXPECT_NEAR(shorter.hausdorff, 80, 0.25);
  EXPECT_NEAR(shorter.far, 100 * 19.0 / 65536, 1e-9);
}

TEST(SurfaceErrors, DotsOnAnyRasterLieWhereTheLineIs) {
  const FinePicture fine(line(10, 20, 200, 120));
  for (const int n : {64, 128, 256, 512}) {
    const auto error = fine.error_of(dots_of(line(10, 20, 200, 120), n));
    EXPECT_EQ(error.mismatch, 0) << n;
    EXPECT_LT(error.hausdorff, 1024.0 / n) << n;
    EXPECT_GT(error.hausdorff, 0.25 * 1024.0 / n) << n;
  }
}

class JonesAccuracy : public testing::Test {
 protected:
  static void SetUpTestSuite() { house = std::make_unique<SceneViews>(compare::jones_precision::six_views[0]); }
  static compare::jones_precision::Precision fixed(int f, bool truncate = false, int bits = programs::jones::machine_word_bits) {
    return {compare::jones_precision::NumberKind::fixed_point, bits, f, truncate};
  }
  static inline std::unique_ptr<SceneViews> house;
};

// Per cent of the visible length: it halves with each fraction bit, and is about twice as large when truncated.
TEST_F(JonesAccuracy, TheHouseHasItsKnownError) {
  EXPECT_NEAR(measure_twin(*house, fixed(0)).symmetric_per_cent(), 0.23, 0.04);
  EXPECT_NEAR(measure_twin(*house, fixed(1)).symmetric_per_cent(), 0.11, 0.04);
  EXPECT_NEAR(measure_twin(*house, fixed(2)).symmetric_per_cent(), 0.05, 0.04);
  EXPECT_NEAR(measure_twin(*house, fixed(0, true)).symmetric_per_cent(), 0.41, 0.04);
}

// By another measure of the same pictures: by line instead of by line number.
TEST_F(JonesAccuracy, TheStudyOfArithmeticMeasuresTheSame) {
  const auto scene = house->scene();
  const auto study = compare::jones_precision::PrecisionStudy::of(scene, compare::jones_precision::six_views[0].eyes);
  for (const int f : {0, 2, 5}) {
    const auto study_error = study->measure(fixed(f)).clipped;
    const auto error = measure_twin(*house, fixed(f));
    EXPECT_NEAR(error.symmetric_per_cent(), 100 * study_error.share(), 1e-3) << f;
    EXPECT_NEAR(error.visible, study_error.visible, 1) << f;
  }
}

TEST_F(JonesAccuracy, DoublePrecisionHasNoMeasurableError) {
  const auto error = measure_twin(*house, {compare::jones_precision::NumberKind::double_float});
  EXPECT_LT(error.symmetric_per_cent(), 1e-9);
  EXPECT_LT(error.hausdorff, 1e-9);
  EXPECT_EQ(error.wrong_visibility.wrong, 0U);
  EXPECT_GT(error.wrong_visibility.points, 10'000U);
}

TEST_F(JonesAccuracy, TheMachineHasItsTwinsErrorAndIsFasterWithTheEae) {
  const MachineBuild build = measure_build(*house, fixed(1));
  const PictureError twin = measure_twin(*house, fixed(1));
  EXPECT_DOUBLE_EQ(build.clipped.symmetric_per_cent(), twin.symmetric_per_cent());
  EXPECT_DOUBLE_EQ(build.clipped.hausdorff, twin.hausdorff);
  EXPECT_GT(build.displayed.hausdorff, build.clipped.hausdorff);
  EXPECT_LT(build.displayed.hausdorff, 1.5) << "rounded to points";
  EXPECT_LT(build.eae_s, build.plain_s);
}

TEST_F(JonesAccuracy, AViewThatOverflowsIsIncompleteAndCounts) {
  const auto error = measure_twin(*house, fixed(4, false, 12));
  EXPECT_EQ(error.incomplete, 6U);
  EXPECT_GT(error.symmetric_per_cent(), 10);
}

}  // namespace
}  // namespace sightline::report
