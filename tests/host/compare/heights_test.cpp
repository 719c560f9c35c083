// Native pictures of functions against what is truly seen, as vectors and cell by cell; and that the
// references themselves are right where that can be said beforehand.
#include "host/compare/heights.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "host/algorithms/skala/draw.hpp"
#include "host/compare/height_truth.hpp"
#include "host/picture/line_metrics_parts.hpp"
#include "host/scene/heights/function.hpp"

namespace sightline::compare {
namespace {

scene::HeightGrid sampled(const char* name, scene::GridSize size) {
  return scene::sample(*scene::height_function(name), size);
}

guests::skala::View view_of(guests::skala::PictureKind picture, double rotation, double elevation = 30) {
  guests::skala::View view;
  view.picture = picture;
  view.rotation = rotation;
  view.elevation = elevation;
  return view;
}

double seen_length(const HeightLines& lines) {
  double length = 0;
  for (const auto& line : lines.lines())
    length += picture::total(line.visible) * picture::length_of(line.image);
  return length;
}

TEST(HeightLines, NothingOfAPlaneIsHiddenAndHalfOfARidgeIs) {
  const HeightLines plane(sampled("flat", {5, 5}), view_of(guests::skala::PictureKind::lines, 20));
  for (const auto& line : plane.lines()) EXPECT_NEAR(picture::total(line.visible), 1, 1e-9);
  // A ridge across the view, seen from the horizon: of the three slices, only the first and the ridge.
  scene::HeightGrid ridge = sampled("flat", {3, 3});
  for (std::size_t i = 0; i < 9; ++i) ridge.heights[i] = i / 3 == 1 ? 1 : 0;
  ridge.range = {0, 1};
  guests::skala::View level = view_of(guests::skala::PictureKind::lines, 0, 10);
  level.family = guests::skala::Family::along_x;
  double back = 0;
  double front = 0;
  const HeightLines ridges(ridge, level);
  for (const auto& line : ridges.lines()) {
    if (std::abs(line.image.a.y - line.image.b.y) > 1e-9) continue;
    const double seen = picture::total(line.visible) * picture::length_of(line.image);
    (line.image.a.y > 128 ? back : front) += seen;
  }
  EXPECT_NEAR(front, 255, 1e-6);
  EXPECT_NEAR(back, 255, 1e-6) << "the ridge, and not the slice behind it";
}

TEST(HeightLines, APieceLeftOutIsMissing) {
  const auto grid = sampled("peaks", {21, 21});
  const guests::skala::View view = view_of(guests::skala::PictureKind::contours, 30);
  const HeightLines lines(grid, view);
  algorithms::skala::View native;
  native.subject = algorithms::skala::Subject::contours;
  native.rotation = 30;
  picture::VectorDrawing drawing = algorithms::skala::draw(grid, native);
  const auto whole = picture::line_metrics(lines.lines(), lines.pieces_of(drawing));
  double lost = 0;
  std::swap(drawing.lines.back(),
            *std::max_element(drawing.lines.begin(), drawing.lines.end(),
                              [](const auto& a, const auto& b) { return a.count < b.count; }));
  const auto line = drawing.lines.back();
  for (std::uint32_t i = 1; i < line.count; ++i) {
    const auto& a = drawing.points[line.first + i - 1];
    const auto& b = drawing.points[line.first + i];
    lost += std::hypot(double{a.x} - double{b.x}, double{a.y} - double{b.y});
  }
  drawing.lines.pop_back();
  const auto less = picture::line_metrics(lines.lines(), lines.pieces_of(drawing));
  ASSERT_GT(lost, 1);
  EXPECT_NEAR(less.missing - whole.missing, lost, 0.02 * lost + 0.05);
  // Of another level's layer, no line of the scene has it.
  ++drawing.lines.back().layer;
  EXPECT_GT(picture::line_metrics(lines.lines(), lines.pieces_of(drawing)).extra, less.extra);
}

TEST(CompareHeights, NativeLinesAndContoursAreWhatIsSeen) {
  for (const char* name : {"sinc", "peaks", "saddle"}) {
    for (const auto picture : {guests::skala::PictureKind::lines, guests::skala::PictureKind::contours}) {
      for (const double rotation : {0.0, 30.0, 180.0, 257.0}) {
        SCOPED_TRACE(std::string(name) +
                     (picture == guests::skala::PictureKind::lines ? " lines " : " contours ") +
                     std::to_string(rotation));
        const auto grid = sampled(name, {21, 25});
        const guests::skala::View view = view_of(picture, rotation);
        const HeightLines lines(grid, view);
        algorithms::skala::View native;
        native.subject = picture == guests::skala::PictureKind::lines ? algorithms::skala::Subject::lines
                                                                      : algorithms::skala::Subject::contours;
        native.rotation = rotation;
        const auto metrics =
            picture::line_metrics(lines.lines(), lines.pieces_of(algorithms::skala::draw(grid, native)));
        // The native algorithm draws contours that graze the horizon to a thirty-second of a point behind it.
        const HeightLines grazing(grid, view, 1.0 / 16);
        const auto generous =
            picture::line_metrics(grazing.lines(), grazing.pieces_of(algorithms::skala::draw(grid, native)));
        EXPECT_NEAR(metrics.true_length, seen_length(lines), 1e-6 * metrics.true_length);
        EXPECT_GT(metrics.true_length, 1000);
        // Masks are a sixteenth of a point wide.
        EXPECT_LT(metrics.share(metrics.missing), 0.005);
        EXPECT_LT(metrics.share(generous.extra), 0.005);
        EXPECT_LT(metrics.missing_far + generous.extra_far, 1);
        EXPECT_LT(metrics.share(metrics.extra), 0.02);
      }
    }
  }
}

TEST(CompareHeights, ASurfaceShowsTheNearestCell) {
  for (const double rotation : {30.0, 200.0}) {
    const auto grid = sampled("peaks", {17, 17});
    const HeightComparison comparison =
        compare_heights(grid, view_of(guests::skala::PictureKind::surface, rotation));
    EXPECT_TRUE(comparison.agrees());
    ASSERT_EQ(comparison.rasters.size(), 4U);
    EXPECT_EQ(comparison.rasters[2].name, "native");
    EXPECT_LT(comparison.rasters[2].metrics.interior_mismatch(), 0.001);
    const ComparedRaster& cells = comparison.rasters[3];
    EXPECT_EQ(cells.name, "native cells");
    EXPECT_EQ(cells.metrics.different_inside, 0U);
    EXPECT_GT(cells.metrics.lit, 20'000U);
    // All facets lie on a cell, and many cells are hidden in part: the truth without order has others.
    EXPECT_LT(*std::max_element(cells.grid.values.begin(), cells.grid.values.end()), 257U);
    EXPECT_EQ(nearest_cells(grid, view_of(guests::skala::PictureKind::surface, rotation)), cells.truth);
  }
}

TEST(CompareHeights, ContoursHaveRasterAndVectors) {
  guests::skala::View view = view_of(guests::skala::PictureKind::contours, 30);
  view.levels = 5;
  const HeightComparison comparison = compare_heights(sampled("sinc", {25, 25}), view);
  EXPECT_TRUE(comparison.agrees()) << comparison.guest_difference;
  ASSERT_EQ(comparison.rasters.size(), 3U);
  ASSERT_EQ(comparison.vectors.size(), 1U);
  const picture::PixelMetrics& native = comparison.rasters[2].metrics;
  // Skala's masks count the outermost two rows as seen: contours that graze the horizon are longer there.
  EXPECT_LT(native.missing_far + native.extra_far, native.lit / 20);
  const double five = comparison.vectors[0].metrics.true_length;
  view.levels = 10;
  EXPECT_GT(compare_heights(sampled("sinc", {25, 25}), view).vectors[0].metrics.true_length, 1.3 * five);
}

}  // namespace
}  // namespace sightline::compare
