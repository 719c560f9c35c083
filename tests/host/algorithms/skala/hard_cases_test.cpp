// The hard cases S1 to S16 of a floating horizon as lines: small grids, flat and end-on surfaces, equal heights, holes, cliffs.
// The
// report has their pictures in dots (host/compare/hard_cases/manifest.json).
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "host/algorithms/skala/draw.hpp"
#include "host/scene/heights/function.hpp"
#include "host/scene/heights/read_grid.hpp"

namespace {

using namespace sightline;
using algorithms::skala::draw;
using algorithms::skala::Family;
using algorithms::skala::Subject;
using algorithms::skala::View;
using picture::VectorDrawing;

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

scene::HeightGrid grid_of(std::size_t points, std::size_t slices, std::vector<double> heights) {
  scene::HeightGrid grid{
      scene::even_positions(points), scene::even_positions(slices), std::move(heights), {}, {}, {}};
  grid.range = scene::finite_range(grid.heights);
  return grid;
}

scene::HeightGrid hard_case_grid(const std::string& file) {
  const auto read = scene::load_height_grid(SIGHTLINE_SOURCE_DIR "/host/compare/hard_cases/data/" + file);
  if (!read) {
    ADD_FAILURE() << read.error().message();
    return {};
  }
  return *read;
}

View lines(Family family, double rotation, double elevation) {
  View view;
  view.family = family;
  view.rotation = rotation;
  view.elevation = elevation;
  view.rims = false;
  return view;
}

std::size_t count(const VectorDrawing& drawing, std::uint32_t layer) {
  std::size_t lines = 0;
  for (const picture::DrawingLine& line : drawing.lines) lines += line.layer == layer ? 1 : 0;
  return lines;
}

TEST(SkalaHardCases, S1TheFirstSliceIsCompletelyVisible) {
  const VectorDrawing drawing = draw(hard_case_grid("S1.csv"), lines(Family::along_x, 0, 30));
  ASSERT_FALSE(drawing.lines.empty());
  EXPECT_EQ(drawing.lines[0].count, 5U);
}

TEST(SkalaHardCases, S2AFlatSurfaceSeenEdgeOnIsDrawnOnce) {
  for (const double rotation : {0.0, 30.0}) {
    View view = lines(Family::along_x, rotation, 0);
    view.rims = true;
    const VectorDrawing drawing = draw(hard_case_grid("S2.csv"), view);
    double ink = 0;
    for (const picture::DrawingLine& line : drawing.lines)
      for (std::uint32_t i = 1; i < line.count; ++i)
        ink +=
            std::abs(double{drawing.points[line.first + i].x} - double{drawing.points[line.first + i - 1].x});
    EXPECT_LE(ink, 255.5);
    EXPECT_GT(ink, 254.0);
  }
}

TEST(SkalaHardCases, S3EqualSlicesAreDrawnOnce) {
  const VectorDrawing drawing = draw(hard_case_grid("S3.csv"), lines(Family::along_x, 0, 0));
  EXPECT_EQ(drawing.lines.size(), 1U);
  EXPECT_EQ(drawing.points.size(), 7U);
}

TEST(SkalaHardCases, S9FlatFromAboveIsTheWholeNet) {
  const VectorDrawing drawing = draw(hard_case_grid("S9.csv"), lines(Family::both, 0, 40));
  EXPECT_EQ(count(drawing, 0), 3U);
  EXPECT_EQ(count(drawing, 1), 4U);
}

TEST(SkalaHardCases, SmallestGrids) {
  for (const double rotation : {0.0, 30.0, 90.0, 180.0, 271.0})
    for (const Family family : {Family::along_x, Family::along_z, Family::both, Family::automatic})
      for (const Subject subject : {Subject::lines, Subject::surface, Subject::contours})
        for (std::size_t points = 1; points <= 3; ++points)
          for (std::size_t slices = 1; slices <= 3; ++slices) {
            std::vector<double> heights;
            for (std::size_t i = 0; i < points * slices; ++i)
              heights.push_back(static_cast<double>(i * i % 5));
            View view = lines(family, rotation, 30);
            view.subject = subject;
            view.silhouette = true;
            const VectorDrawing drawing = draw(grid_of(points, slices, heights), view);
            EXPECT_TRUE(subject != Subject::lines || !drawing.lines.empty());
            for (const picture::DrawingPoint p : drawing.points)
              EXPECT_TRUE(p.x >= 0 && p.x <= 255 && p.y >= 0 && p.y <= 255) << p.x << ' ' << p.y;
          }
  EXPECT_TRUE(draw(grid_of(0, 0, {}), {}).lines.empty());
}

TEST(SkalaHardCases, ASinglePointIsADot) {
  const VectorDrawing drawing = draw(grid_of(1, 1, {3}), {});
  ASSERT_EQ(drawing.lines.size(), 1U);
  EXPECT_EQ(drawing.lines[0].count, 1U);
  EXPECT_NEAR(drawing.points[0].x, 127.5, 0.1);
}

TEST(SkalaHardCases, OneSliceIsItsCurve) {
  const VectorDrawing drawing = draw(grid_of(4, 1, {0, 2, 1, 3}), lines(Family::along_x, 0, 20));
  ASSERT_EQ(drawing.lines.size(), 1U);
  ASSERT_EQ(drawing.lines[0].count, 4U);
  const double expected[] = {0, 170, 85, 255};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(drawing.points[i].y, expected[i], 0.001);
}

TEST(SkalaHardCases, S5EndOnSlicesAreUprightLines) {
  const VectorDrawing drawing = draw(hard_case_grid("S5.csv"), lines(Family::along_x, 90, 30));
  ASSERT_EQ(drawing.lines.size(), 4U);
  std::set<float> places;
  for (const picture::DrawingLine& line : drawing.lines)
    for (std::uint32_t i = 0; i < line.count; ++i) places.insert(drawing.points[line.first + i].x);
  EXPECT_EQ(places.size(), 4U);
}

TEST(SkalaHardCases, S4ACliffDoesNotHideItself) {
  // A step in 1/100 of the width: both slices go up and down again.
  const VectorDrawing drawing = draw(hard_case_grid("S4.dat"), lines(Family::along_x, 0, 30));
  ASSERT_FALSE(drawing.lines.empty());
  EXPECT_EQ(drawing.lines[0].count, 5U);
}

TEST(SkalaHardCases, UndefinedHeightsBreakSlicesAndHideNothing) {
  std::vector<double> heights(7 * 5, 1.0);
  heights[3 + 7] = undefined;
  heights[3] = std::numeric_limits<double>::infinity();
  const scene::HeightGrid grid = grid_of(7, 5, heights);
  const VectorDrawing drawing = draw(grid, lines(Family::along_x, 0, 45));
  EXPECT_EQ(drawing.lines.size(), 7U);
  const VectorDrawing nothing = draw(grid_of(3, 3, std::vector<double>(9, undefined)), {});
  EXPECT_TRUE(nothing.lines.empty());
}

TEST(SkalaHardCases, S10IslandsHaveNoStripBetweenThem) {
  // Two peaks with a gap between them; the far wall is visible through the gap.
  const VectorDrawing drawing = draw(hard_case_grid("S10.csv"), lines(Family::along_x, 0, 5));
  bool through = false;
  for (const picture::DrawingLine& line : drawing.lines)
    through = through ||
              (drawing.points[line.first].x < 120 && drawing.points[line.first + line.count - 1].x > 130);
  EXPECT_TRUE(through);
}

TEST(SkalaHardCases, S15TheUndersideOfAPitIsSeen) {
  // A bowl whose bottom hangs below the near edge.
  const VectorDrawing drawing = draw(hard_case_grid("S15.csv"), lines(Family::along_x, 0, 10));
  bool bottom = false;
  for (const picture::DrawingPoint p : drawing.points) bottom = bottom || p.y == 0;
  EXPECT_TRUE(bottom);
}

TEST(SkalaHardCases, S16AContourAtVerticesIsOneLine) {
  // Levels 0.5, 1, 1.5 of 0..2: the middle one passes through a whole row of vertices.
  View view = lines(Family::automatic, 0, 60);
  view.subject = Subject::contours;
  view.levels = 3;
  const VectorDrawing drawing = draw(hard_case_grid("S16.csv"), view);
  for (std::uint32_t layer = 4; layer < 7; ++layer) EXPECT_EQ(count(drawing, layer), 1U) << layer;
}

TEST(SkalaHardCases, HugeAndTinyHeights) {
  for (const double scale : {1e308, 1e-308, 5e-324}) {
    const VectorDrawing drawing =
        draw(grid_of(3, 3, {0, scale, 0, -scale, scale, 0, 0, 0, -scale}), lines(Family::both, 30, 30));
    EXPECT_FALSE(drawing.lines.empty());
    for (const picture::DrawingPoint p : drawing.points) EXPECT_TRUE(p.y >= 0 && p.y <= 255);
  }
}

// Their halves are equal, so that the position of a level between them is undefined.
TEST(SkalaHardCases, ContoursBetweenHeightsThatHardlyDiffer) {
  constexpr double least = 5e-324;
  for (const int levels : {1, 7}) {
    View view = lines(Family::automatic, 30, 30);
    view.subject = Subject::contours;
    view.levels = levels;
    const VectorDrawing drawing = draw(grid_of(3, 3, {-1, -least, 0, -1, 0, 1, -least, 0, 1}), view);
    EXPECT_GE(count(drawing, 4), 1U);
    for (const picture::DrawingPoint p : drawing.points) EXPECT_TRUE(p.x >= 0 && p.y >= 0 && p.y <= 255);
  }
}

TEST(SkalaHardCases, S14TheFirstSliceIsWholeAtTheFinestMasks) {
  View view = lines(Family::along_x, 0, 30);
  view.columns = algorithms::skala::most_columns;
  const scene::HeightGrid grid = hard_case_grid("S14.csv");
  const VectorDrawing drawing = draw(grid, view);
  ASSERT_FALSE(drawing.lines.empty());
  EXPECT_EQ(drawing.lines[0].count, grid.points());
}

TEST(SkalaHardCases, MasksOfAnyWidth) {
  for (const int columns : {0, 16, 255, 5000, 1 << 20}) {
    View view = lines(Family::both, 30, 30);
    view.columns = columns;
    const VectorDrawing drawing = draw(sample(*scene::height_function("sinc"), {65, 65}), view);
    EXPECT_GT(drawing.lines.size(), 60U);
  }
}

}  // namespace
