// Laws that hold for every drawing of every surface.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "host/algorithms/skala/draw.hpp"
#include "host/algorithms/skala/walk.hpp"
#include "host/scene/heights/function.hpp"

namespace {

using namespace sightline;
using algorithms::skala::Family;
using algorithms::skala::Subject;
using algorithms::skala::View;
using picture::VectorDrawing;

scene::HeightGrid grid_of(const char* name, std::size_t points = 21, std::size_t slices = 17) {
  return sample(*scene::height_function(name), {points, slices});
}

double length_of(const VectorDrawing& drawing, std::uint32_t layer) {
  double length = 0;
  for (const picture::DrawingLine& line : drawing.lines)
    for (std::uint32_t i = 1; i < line.count && line.layer == layer; ++i) {
      const auto a = drawing.points[line.first + i - 1];
      const auto b = drawing.points[line.first + i];
      length += std::hypot(double{b.x} - double{a.x}, double{b.y} - double{a.y});
    }
  return length;
}

bool near_segment(picture::DrawingPoint p, picture::DrawingPoint a, picture::DrawingPoint b) {
  const double ux = double{b.x} - double{a.x}, uy = double{b.y} - double{a.y};
  const double vx = double{p.x} - double{a.x}, vy = double{p.y} - double{a.y};
  const double square = ux * ux + uy * uy;
  const double t = square > 0 ? std::clamp((ux * vx + uy * vy) / square, 0.0, 1.0) : 0;
  return std::hypot(vx - t * ux, vy - t * uy) < 0.001;
}

class Views : public testing::TestWithParam<double> {};

TEST_P(Views, WithoutVisibilityEverythingIsDrawn) {
  for (const Subject subject : {Subject::lines, Subject::contours}) {
    View view;
    view.subject = subject;
    view.rotation = GetParam();
    view.family = Family::both;
    const scene::HeightGrid grid = grid_of("peaks", 11, 9);
    const VectorDrawing visible = draw(grid, view);
    view.visibility = false;
    const VectorDrawing everything = draw(grid, view);
    for (const picture::DrawingLine& line : visible.lines)
      for (std::uint32_t i = 0; i < line.count; ++i) {
        bool found = false;
        for (const picture::DrawingLine& other : everything.lines)
          for (std::uint32_t j = 1; j < other.count && other.layer == line.layer && !found; ++j)
            found = near_segment(visible.points[line.first + i], everything.points[other.first + j - 1],
                                 everything.points[other.first + j]);
        EXPECT_TRUE(found) << line.layer;
      }
  }
}

// Data turned by 90 degrees and seen from 90 degrees less give the same picture, with the families exchanged.
TEST_P(Views, AQuarterTurnOfTheDataIsAQuarterTurnOfTheEye) {
  const scene::HeightGrid grid = grid_of("rogers");
  scene::HeightGrid turned{grid.z, grid.x, {}, grid.domain_z, grid.domain_x, grid.range};
  // x' = z, z' = -x
  for (std::size_t slice = 0; slice < turned.slices(); ++slice)
    for (std::size_t point = 0; point < turned.points(); ++point)
      turned.heights.push_back(grid.height(grid.points() - 1 - slice, point));
  View view;
  view.rotation = GetParam();
  view.family = Family::along_x;
  View other = view;
  other.rotation = GetParam() - 90;
  other.family = Family::along_z;
  const VectorDrawing a = draw(grid, view);
  const VectorDrawing b = draw(turned, other);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.lines, b.lines);
}

TEST_P(Views, MirroredDataGiveTheMirroredPicture) {
  const bool square =
      std::fmod(GetParam(), 90.0) == 0;  // cells have no nearest corner, but are divided all the same
  for (const Subject subject : {Subject::lines, square ? Subject::lines : Subject::contours}) {
    const scene::HeightGrid grid = grid_of("peaks");
    scene::HeightGrid mirrored = grid;
    for (std::size_t slice = 0; slice < grid.slices(); ++slice)
      for (std::size_t point = 0; point < grid.points(); ++point)
        mirrored.heights[slice * grid.points() + point] = grid.height(grid.points() - 1 - point, slice);
    View view;
    view.subject = subject;
    view.family = Family::both;
    view.rotation = GetParam();
    View back = view;
    back.rotation = -view.rotation;
    const VectorDrawing a = draw(grid, view);
    const VectorDrawing b = draw(mirrored, back);
    ASSERT_EQ(a.layers.size(), b.layers.size());
    double total = 0;
    for (std::uint32_t layer = 0; layer < a.layers.size(); ++layer) total += length_of(a, layer);
    for (std::uint32_t layer = 0; layer < a.layers.size(); ++layer)
      EXPECT_NEAR(length_of(a, layer), length_of(b, layer), 0.001 * total) << layer;
  }
}

// Finer masks move the ends of lines by less than one coarse column. (For the family that is less end-on: the lines of the other
// are
// so steep that a column is a large part of their length.)
TEST_P(Views, FinerMasksAgree) {
  View view;
  view.rotation = GetParam();
  const scene::HeightGrid grid = grid_of("sinc");
  const VectorDrawing coarse = draw(grid, view);
  view.columns = algorithms::skala::most_columns;
  EXPECT_NEAR(length_of(coarse, 0) / length_of(draw(grid, view), 0), 1, 0.002);
}

// Faces seen from below equal those of the inverted surface seen from above.
TEST_P(Views, FromBelowIsTheNegativeFromAbove) {
  const scene::HeightGrid grid = grid_of("franke");
  scene::HeightGrid over = grid;
  for (double& height : over.heights) height = -height;
  over.range = {-grid.range.high, -grid.range.low};
  View view;
  view.rotation = GetParam();
  View below = view;
  below.elevation = -view.elevation;
  const VectorDrawing a = draw(grid, view);
  const VectorDrawing b = draw(over, below);
  EXPECT_NEAR(length_of(a, 0) / length_of(b, 0), 1, 0.0005);
}

INSTANTIATE_TEST_SUITE_P(Skala, Views, testing::Values(0.0, 17.0, 45.0, 90.0, 135.0, 200.0, 269.5, 330.0));

// Without visibility a contour of a closed hill is one closed line per level, all of it at its level.
TEST(SkalaContours, AreClosedLinesAtTheirLevel) {
  View view;
  view.subject = Subject::contours;
  view.visibility = false;
  view.elevation = 90;
  view.rims = false;
  view.levels = 5;
  const VectorDrawing drawing = draw(grid_of("gauss", 31, 31), view);
  ASSERT_EQ(drawing.layers.size(), 9U);
  ASSERT_EQ(drawing.lines.size(), 5U);
  for (const picture::DrawingLine& line : drawing.lines) {
    EXPECT_EQ(drawing.points[line.first], drawing.points[line.first + line.count - 1]);
    // exp(-r^2) on +-3, range 0..1: of level k / 6 the radius is sqrt(log(6 / k)).
    const double k = line.layer - algorithms::skala::first_contour + 1;
    const double radius = std::sqrt(std::log(6 / k)) / 3 * 127.5;
    for (std::uint32_t i = 0; i < line.count; ++i) {
      const picture::DrawingPoint p = drawing.points[line.first + i];
      EXPECT_NEAR(std::hypot(double{p.x} - 127.5, double{p.y} - 127.5), radius, 1.5);
    }
  }
}

TEST(SkalaSurface, HiddenCellsAreOmittedAndTheRestIsFarToNear) {
  View view;
  view.subject = Subject::surface;
  const VectorDrawing drawing = draw(grid_of("sinc", 41, 41), view);
  EXPECT_TRUE(drawing.lines.empty());
  EXPECT_LT(drawing.facets.size(), 1600U);
  EXPECT_GT(drawing.facets.size(), 1000U);
  for (const picture::DrawingFacet& facet : drawing.facets) EXPECT_TRUE(facet.count == 3 || facet.count == 4);
}

// The masks omit only cells that the painter would cover: the picture of all cells is the same.
TEST(SkalaSurface, OmittingHiddenCellsChangesNoPixel) {
  for (const char* name : {"sinc", "peaks", "rosen", "step"}) {
    View view;
    view.subject = Subject::surface;
    view.rotation = 30;
    const scene::HeightGrid grid = grid_of(name, 25, 25);
    const VectorDrawing seen = draw(grid, view);
    view.visibility = false;
    const VectorDrawing all = draw(grid, view);
    EXPECT_LT(seen.facets.size(), all.facets.size()) << name;
    EXPECT_TRUE(image_of(seen, {400, 400, 1}) == image_of(all, {400, 400, 1})) << name;
  }
}

}  // namespace
