// Native pictures of functions compared with the visible parts, as vectors and cell by cell; and tests of the references
// themselves
// where the result is known beforehand.
#include "host/compare/heights.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "host/algorithms/skala/draw.hpp"
#include "host/compare/chord_error.hpp"
#include "host/compare/height_devices.hpp"
#include "host/compare/height_truth.hpp"
#include "host/picture/line_metrics_parts.hpp"
#include "host/scene/heights/function.hpp"

namespace sightline::compare {
namespace {

scene::HeightGrid sample_function(const char* name, scene::GridSize size) {
  return scene::sample(*scene::height_function(name), size);
}

algorithms::skala::View view_of(algorithms::skala::Subject picture, double rotation, double elevation = 30) {
  algorithms::skala::View view;
  view.subject = picture;
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
  const HeightLines plane(sample_function("flat", {5, 5}), view_of(algorithms::skala::Subject::lines, 20));
  for (const auto& line : plane.lines()) EXPECT_NEAR(picture::total(line.visible), 1, 1e-9);
  // A ridge across the view, seen from the horizon: only the first of the three slices and the ridge are visible.
  scene::HeightGrid ridge = sample_function("flat", {3, 3});
  for (std::size_t i = 0; i < 9; ++i) ridge.heights[i] = i / 3 == 1 ? 1 : 0;
  ridge.range = {0, 1};
  algorithms::skala::View level = view_of(algorithms::skala::Subject::lines, 0, 10);
  level.family = algorithms::skala::Family::along_x;
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

TEST(HeightLines, AnOmittedPieceIsMissing) {
  const auto grid = sample_function("peaks", {21, 21});
  const algorithms::skala::View view = view_of(algorithms::skala::Subject::contours, 30);
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
  // No line of the scene has the layer of another level.
  ++drawing.lines.back().layer;
  EXPECT_GT(picture::line_metrics(lines.lines(), lines.pieces_of(drawing)).extra, less.extra);
}

TEST(CompareHeights, NativeLinesAndContoursAreTheVisibleParts) {
  for (const char* name : {"sinc", "peaks", "saddle"}) {
    for (const auto picture : {algorithms::skala::Subject::lines, algorithms::skala::Subject::contours}) {
      for (const double rotation : {0.0, 30.0, 180.0, 257.0}) {
        SCOPED_TRACE(std::string(name) +
                     (picture == algorithms::skala::Subject::lines ? " lines " : " contours ") +
                     std::to_string(rotation));
        const auto grid = sample_function(name, {21, 25});
        const algorithms::skala::View view = view_of(picture, rotation);
        const HeightLines lines(grid, view);
        algorithms::skala::View native;
        native.subject = picture == algorithms::skala::Subject::lines ? algorithms::skala::Subject::lines
                                                                      : algorithms::skala::Subject::contours;
        native.rotation = rotation;
        const auto metrics =
            picture::line_metrics(lines.lines(), lines.pieces_of(algorithms::skala::draw(grid, native)));
        // The native algorithm draws contours that graze the horizon up to a thirty-second of a point behind it.
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
    const auto grid = sample_function("peaks", {17, 17});
    const HeightComparison comparison =
        compare_heights(grid, view_of(algorithms::skala::Subject::surface, rotation));
    EXPECT_TRUE(comparison.agrees());
    ASSERT_EQ(comparison.rasters.size(), 4U);
    EXPECT_EQ(comparison.rasters[2].name, "native");
    EXPECT_LT(comparison.rasters[2].metrics.interior_mismatch(), 0.001);
    const ComparedRaster& cells = comparison.rasters[3];
    EXPECT_EQ(cells.name, "native cells");
    EXPECT_EQ(cells.metrics.different_inside, 0U);
    EXPECT_GT(cells.metrics.lit, 20'000U);
    // All facets are on a cell, and many cells are partly hidden: without order the reference would have others.
    EXPECT_LT(*std::max_element(cells.grid.values.begin(), cells.grid.values.end()), 257U);
    EXPECT_EQ(nearest_cells(grid, view_of(algorithms::skala::Subject::surface, rotation)), cells.truth);
  }
}

TEST(CompareHeights, AProgramsRoundingIsMeasured) {
  const HeightComparison comparison = compare_heights(sample_function("sinc", {33, 30}), view_of(algorithms::skala::Subject::lines, 30));
  ASSERT_EQ(comparison.rasters.size(), 3U);
  for (const std::size_t program : {0U, 1U}) {
    const ComparedRaster& row = comparison.rasters[program];
    EXPECT_EQ(row.metrics.different(), 0U) << "the oracle rounds as it does";
    ASSERT_TRUE(row.unrounded);
    // A line one step aside is half a dot off; rounding of an end adds another half.
    EXPECT_GT(row.unrounded->hausdorff.usual, 0.5);
    EXPECT_LT(row.unrounded->hausdorff.greatest, 2);
    EXPECT_EQ(row.unrounded->dots_beyond_2, 0U);
    EXPECT_EQ(row.unrounded->dots, row.metrics.lit);
    ASSERT_TRUE(row.from_native);
    EXPECT_LT(row.from_native->missing.all, row.from_native->lit_in_truth / 50) << "the rule is the program's";
    EXPECT_EQ(row.from_native->missing.beyond_2, 0U);
    EXPECT_NE(row.rounding, "");
  }
  // Vectors are rounded to the nearest dots: less than 0.5 across, and at most half of the way to the next dot.
  ASSERT_TRUE(comparison.rasters[2].unrounded);
  EXPECT_LT(comparison.rasters[2].unrounded->hausdorff.greatest, 1);
  EXPECT_FALSE(comparison.rasters[2].from_native);
  EXPECT_FALSE(comparison.chord) << "nothing to sample";
}

TEST(CompareDevices, DrawExactLinesWithinRounding) {
  const auto devices = compare_devices(sample_function("peaks", {21, 25}), view_of(algorithms::skala::Subject::lines, 30));
  ASSERT_EQ(devices.size(), 4U);
  for (const ComparedDevice& device : devices) {
    SCOPED_TRACE(std::string(device.name));
    EXPECT_EQ(device.difference, "");
    EXPECT_GT(device.raster.lit_in_drawn, 3000U);
    EXPECT_EQ(device.raster.missing.beyond_2, 0U);
    EXPECT_EQ(device.raster.extra.beyond_2, 0U);
    EXPECT_LT(device.raster.missing.all + device.raster.extra.all, device.raster.lit_in_truth * 3 / 100);
    ASSERT_TRUE(device.unrounded);
    EXPECT_GT(device.unrounded->hausdorff.greatest, 0.5) << "the rounding";
  }
  EXPECT_EQ(devices[0].dots, devices[1].dots) << "boards show the same";
  EXPECT_EQ(devices[2].dots, devices[3].dots) << "plotters too";
}

TEST(CompareDevices, ABoardFillsASurfaceAndAPlotterDrawsItsSlices) {
  const auto grid = sample_function("peaks", {21, 25});
  const auto surface = compare_devices(grid, view_of(algorithms::skala::Subject::surface, 30));
  const auto lines = compare_devices(grid, view_of(algorithms::skala::Subject::lines, 30));
  EXPECT_FALSE(surface[0].unrounded);
  EXPECT_GT(surface[0].raster.lit_in_truth, 20'000U);
  EXPECT_LT(surface[0].raster.extra.all, surface[0].raster.lit_in_truth * 3 / 100);
  EXPECT_EQ(surface[2].dots, lines[2].dots);
  EXPECT_EQ(surface[2].truth, lines[2].truth);
}

TEST(ChordError, OfAParabola) {
  // From the horizon, at x = -1, -0.5 .. 1: a chord is (0.5)^2 / 4 above the middle of its arc. A height of 1 spans 255 points.
  // The
  // chords are steep, least the two inner ones, by 1 in 1.
  const HeightSampler parabola = [](scene::GridSize size) {
    return scene::sample_values([](double x, double) { return x * x; }, {{-1, 1}, {-1, 1}}, size);
  };
  const scene::HeightGrid grid = parabola({5, 4});
  algorithms::skala::View view = view_of(algorithms::skala::Subject::lines, 0, 0);
  view.family = algorithms::skala::Family::along_x;
  const auto error = chord_error(HeightLines(grid, view), grid, view, parabola);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->between, 15U);
  EXPECT_NEAR(error->greatest, 255.0 / 16 / std::sqrt(2.0), 1e-9);
  // Four times as many samples: a sixteenth of the error.
  const scene::HeightGrid fine = parabola({17, 4});
  const auto less = chord_error(HeightLines(fine, view), fine, view, parabola);
  ASSERT_TRUE(less);
  EXPECT_NEAR(less->greatest, 255.0 / 256 / std::hypot(1, 0.25), 1e-9) << "the innermost chord rises 1 in 4";
  EXPECT_FALSE(chord_error(HeightLines(grid, view), grid, view, {}));
}

TEST(ChordError, IsThatOfTheVisibleParts) {
  // A wall in front of a needle between two samples.
  const auto function = [](double needle) {
    return [needle](scene::GridSize size) {
      return scene::sample_values(
          [needle](double x, double z) { return z < -0.5 ? 1.0 : std::abs(x - 0.25) < 0.1 && z > 0.5 ? needle : 0.0; },
          {{-1, 1}, {-1, 1}}, size);
    };
  };
  algorithms::skala::View view = view_of(algorithms::skala::Subject::lines, 0, 10);
  view.family = algorithms::skala::Family::along_x;
  const HeightSampler sampler = function(0.5);
  const scene::HeightGrid grid = sampler({5, 5});
  const HeightLines lines(grid, view);
  double behind = 0;
  for (std::size_t i = 0; i < lines.lines().size(); ++i) {
    const auto& [from, to] = *lines.sides()[i];
    if (from.slice == 4 && to.slice == 4) behind += picture::total(lines.lines()[i].visible);
  }
  ASSERT_EQ(behind, 0) << "the last slice is behind the wall";
  const auto error = chord_error(lines, grid, view, sampler);
  ASSERT_TRUE(error);
  EXPECT_LT(error->greatest, chord_error(HeightLines(grid, view_of(algorithms::skala::Subject::lines, 0, 60)), grid,
                                         view_of(algorithms::skala::Subject::lines, 0, 60), sampler)
                                 ->greatest);
}

TEST(CompareHeights, ContoursHaveRasterAndVectors) {
  algorithms::skala::View view = view_of(algorithms::skala::Subject::contours, 30);
  view.levels = 5;
  const HeightComparison comparison = compare_heights(sample_function("sinc", {25, 25}), view);
  EXPECT_TRUE(comparison.agrees()) << comparison.guest_difference;
  ASSERT_EQ(comparison.rasters.size(), 3U);
  ASSERT_EQ(comparison.vectors.size(), 1U);
  const picture::PixelMetrics& native = comparison.rasters[2].metrics;
  // Skala's masks count the outermost two rows as visible: contours that graze the horizon are longer there.
  EXPECT_LT(native.missing_far + native.extra_far, native.lit / 20);
  const double five = comparison.vectors[0].metrics.true_length;
  view.levels = 10;
  EXPECT_GT(compare_heights(sample_function("sinc", {25, 25}), view).vectors[0].metrics.true_length, 1.3 * five);
}

}  // namespace
}  // namespace sightline::compare
