// Line pictures as drawings: positions of points, clipping, joined lines, dashes.
#include "host/picture/line_drawing.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "host/picture/hatching.hpp"
#include "host/scene/model/poly_builder.hpp"

namespace sightline::picture {
namespace {

// A square of 2 x 2 at z = 4, seen from the origin along z.
scene::PolyScene square(std::int32_t half = 1, std::int32_t z = 4) {
  scene::PolyBuilder builder;
  const std::array<scene::PolyPoint, 4> outline{
      {{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}}};
  builder.add_sheet("square", outline);
  return builder.take();
}

DrawingField field(double width, double height, std::optional<double> extent = std::nullopt) {
  DrawingField f;
  f.width = width;
  f.height = height;
  f.extent = extent;
  return f;
}

std::size_t count_in(const VectorDrawing& drawing, std::uint32_t layer) {
  std::size_t count = 0;
  for (const DrawingLine& line : drawing.lines) count += line.layer == layer ? 1U : 0U;
  return count;
}

TEST(LineDrawing, FittedIntoTheMiddleAndUndistorted) {
  const scene::PolyScene scene = square();
  const VectorDrawing drawing = line_drawing(wire_frame(scene), scene, {}, field(300, 100));
  ASSERT_EQ(drawing.lines.size(), 1U) << "one line around";
  EXPECT_EQ(drawing.lines[0].count, 5U);
  for (const DrawingPoint& p : drawing.points) {
    EXPECT_TRUE(p.x == 100 || p.x == 200) << p.x;
    EXPECT_TRUE(p.y == 0 || p.y == 100) << p.y;
  }
}

TEST(LineDrawing, AFieldInDegrees) {
  // 90 degrees: x / z = 1 is the border. The square's corners are at 1/4.
  const scene::PolyScene scene = square();
  const VectorDrawing drawing = line_drawing(wire_frame(scene), scene, {}, field(100, 100, 90));
  for (const DrawingPoint& p : drawing.points) {
    EXPECT_NEAR(std::abs(p.x - 50), 12.5, 1e-4);
    EXPECT_NEAR(std::abs(p.y - 50), 12.5, 1e-4);
  }
}

TEST(LineDrawing, LinesAreClippedToTheField) {
  const scene::PolyScene scene = square(8);  // corners at 2, sides completely outside the window
  EXPECT_TRUE(line_drawing(wire_frame(scene), scene, {}, field(100, 100, 90)).lines.empty());
  scene::PolyCamera camera;
  camera.eye = {8, 0, 0};  // the right side crosses the middle from top to bottom
  const VectorDrawing drawing = line_drawing(wire_frame(scene), scene, camera, field(100, 100, 90));
  ASSERT_EQ(drawing.lines.size(), 1U);
  ASSERT_EQ(drawing.points.size(), 2U);
  EXPECT_EQ(drawing.points[0], (DrawingPoint{50, 0}));
  EXPECT_EQ(drawing.points[1], (DrawingPoint{50, 100}));
}

TEST(LineDrawing, AroundTheEyeLinesAreClippedToTheDefaultAngle) {
  scene::PolyBuilder builder;
  builder.add_box("room", {-10, -10, -10}, {10, 10, 20});
  const scene::PolyScene scene = builder.take();
  const VectorDrawing drawing = line_drawing(wire_frame(scene), scene, {}, field(100, 100));
  ASSERT_FALSE(drawing.lines.empty());
  for (const DrawingPoint& p : drawing.points) {
    EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
    EXPECT_TRUE(0 <= p.x && p.x <= 100 && 0 <= p.y && p.y <= 100);
  }
}

TEST(LineDrawing, WithoutPerspectiveInSceneUnits) {
  const scene::PolyScene scene = square();
  scene::PolyCamera camera;
  camera.perspective = false;
  const VectorDrawing drawing = line_drawing(wire_frame(scene), scene, camera, field(100, 100, 4));
  for (const DrawingPoint& p : drawing.points) EXPECT_EQ(std::abs(p.x - 50), 25);
}

TEST(LineDrawing, HiddenPartsAreDashedFromEndToEnd) {
  const scene::PolyScene scene = square();
  const LinePicture edges = wire_frame(scene);
  LinePicture seen = edges;
  seen.pieces.resize(1);
  seen.pieces[0].high = geometry::Rational(1, 2);
  DrawingField f = field(100, 100);
  f.dash = 2;
  const std::array layers{LineLayer{"visible", seen}, hidden_layer(hidden_pieces(edges, seen))};
  const VectorDrawing drawing = with_dashes(line_drawing(layers, scene, {}, f));
  ASSERT_EQ(drawing.layers.size(), 2U);
  EXPECT_EQ(count_in(drawing, 0), 1U);
  // 3 sides of 100 with about 29 dashes of 2 and gaps of 1.5, and half a side.
  EXPECT_EQ(count_in(drawing, 1), 3 * 29U + 15U);
  double length = 0;
  for (const DrawingLine& line : drawing.lines) {
    const DrawingPoint& a = drawing.points[line.first];
    const DrawingPoint& b = drawing.points[line.first + 1];
    if (line.layer == 1) length += std::hypot(double{b.x} - a.x, double{b.y} - a.y);
  }
  EXPECT_NEAR(length, 350 * 4.0 / 7.0, 4);
}

TEST(LineDrawing, CoincidingEdgesAreDrawnOnce) {
  scene::PolyScene scene = square();
  const std::size_t count = scene.vertices.size();
  for (std::size_t v = 0; v < count; ++v) scene.vertices.push_back(scene.vertices[v]);
  scene.bodies.push_back(scene.bodies[0]);
  for (scene::VertexIndex& v : scene.bodies[1].faces[0].outline) v += static_cast<scene::VertexIndex>(count);
  const VectorDrawing drawing = line_drawing(wire_frame(scene), scene, {}, field(100, 100));
  ASSERT_EQ(drawing.lines.size(), 1U);
  EXPECT_EQ(drawing.lines[0].count, 5U);
}

TEST(LineDrawing, ALineThatOnlyTouchesTheBorderIsOmitted) {
  const std::array layers{LineLayer{"visible", {}}};
  const ImageWindow window{{-1, -1}, {1, 1}};
  UnitedLines lines;
  lines.lines = {{{1, 0, 1}, {2, 0, 1}}, {{0.5, 2, 1}, {0.5, 1, 1}}, {{1, 0, 1}, {1, 0.5, 1}}};
  const auto strokes = strokes_in(lines, layers, window, field(100, 100));
  ASSERT_EQ(strokes.size(), 1U);
  EXPECT_EQ(strokes[0].to, (std::array{1.0, 0.5})) << "the one along the border";
}

// Only lines with a free end are omitted, and the lengths are those of lines, not of their parts.
TEST(LineDrawing, ShortLinesAreOmittedUnlessTheyCloseAGap) {
  const std::array layers{LineLayer{"silhouette", {}}, LineLayer{"crease", {}}};
  const ImageWindow window{{0, 0}, {10, 10}};
  DrawingField f = field(10, 10);
  f.min_length = 1;
  UnitedLines lines;
  lines.lines = {
      {{0, 0, 1}, {10, 0, 1}, 0}, {{2, 1, 1}, {2, 9, 1}, 0}, {{2.5, 1, 1}, {2.5, 9, 1}, 0},                       // long
      {{2, 5, 1}, {2.5, 5, 1}, 1},                                                                               // across a slit
      {{6, 6, 1}, {6.3, 6, 1}, 1}, {{6, 6, 1}, {6, 6.3, 1}, 1}, {{6.3, 6, 1}, {6, 6.3, 1}, 1},                      // closed
      {{4, 8, 1}, {4.6, 8, 1}, 1}, {{4.6, 8, 1}, {5.2, 8.1, 1}, 1},                                              // together long enough
      {{7, 3, 1}, {7.5, 3, 1}, 1},                                                                               // alone
      {{5, 0, 1}, {5, 0.5, 1}, 1},                                                                               // from a line
      {{10, 0, 1}, {10, 0.9, 1}, 1},                                                                             // from a corner
  };
  const auto strokes = strokes_in(lines, layers, window, f);
  EXPECT_EQ(strokes.size(), 9U);
  for (const LineStroke& stroke : strokes) {
    EXPECT_NE(stroke.from[0], 7);
    EXPECT_NE(stroke.from[0], 5);
    EXPECT_NE(stroke.from[0], 10);
  }
  f.min_length = 0;
  EXPECT_EQ(strokes_in(lines, layers, window, f).size(), 12U);
}

// Edges first, then hatching, then hidden lines; all but for rounding.
TEST(Hatching, LeavesOutWhatLiesOnEdgesAndHidesDashes) {
  const std::array layers{LineLayer{"crease", {}, {}, "crease"}, LineLayer{"hatching", {}, {}, std::string(hatching_kinds[0])},
                          hidden_layer({}, "crease")};
  UnitedLines lines;
  lines.lines = {{{0, 5, 1}, {4, 5, 1}, 0}, {{0, 5 + 1e-9, 1}, {10, 5 + 1e-9, 1}, 1}, {{6, 5, 1}, {12, 5, 1}, 2}, {{6, 5, 1}, {6, 9, 1}, 2}};
  leave_out_hatching_on_lines(lines, layers, {{0, 0}, {10, 10}});
  ASSERT_EQ(lines.lines.size(), 4U);
  EXPECT_EQ(lines.lines[0].to[0], 4);
  EXPECT_NEAR(lines.lines[1].from[0], 4, 1e-9);
  EXPECT_NEAR(lines.lines[1].to[0], 10, 1e-9);
  EXPECT_NEAR(lines.lines[2].from[0], 10, 1e-9);
  EXPECT_NEAR(lines.lines[2].to[0], 12, 1e-9);
  EXPECT_EQ(lines.lines[3].to[1], 9) << "across";
}

TEST(LineDrawing, AnEmptyPictureGivesAnEmptyDrawing) {
  const scene::PolyScene scene = square();
  const VectorDrawing drawing = line_drawing(LinePicture{}, scene, {}, field(100, 50));
  EXPECT_TRUE(drawing.lines.empty());
  EXPECT_EQ(drawing.width, 100);
  EXPECT_EQ(drawing.height, 50);
}

}  // namespace
}  // namespace sightline::picture
