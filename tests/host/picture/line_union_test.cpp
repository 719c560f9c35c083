// Each stretch of the image is drawn once: compared with the exact set of drawn points (image_set), which is computed with
// fractions.
#include "host/picture/line_union.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/picture/line_drawing.hpp"
#include "host/picture/line_picture_image.hpp"
#include "host/scene/model/aim_camera.hpp"
#include "host/scene/model/eye_place.hpp"
#include "host/scene/model/poly_builder.hpp"
#include "tests/support/dice.hpp"
#include "tests/support/effort.hpp"

namespace sightline::picture {
namespace {

using programs::jones::Dice;

// Boxes on a coarse grid, so that many edges coincide in space and in the image.
scene::PolyScene bricks(Dice& dice) {
  scene::PolyBuilder builder;
  for (int b = dice(1, 6); b > 0; --b) {
    const scene::PolyPoint low{dice(0, 4) * 10, dice(0, 4) * 10, dice(0, 4) * 10};
    builder.add_box("", low, {low[0] + 10 * dice(1, 2), low[1] + 10 * dice(1, 2), low[2] + 10 * dice(1, 2)});
  }
  return builder.take();
}

double length_of(const UnitedLine& line) {
  return std::hypot(line.to[0] / line.to[2] - line.from[0] / line.from[2], line.to[1] / line.to[2] - line.from[1] / line.from[2]);
}

// The ends of each segment, along its line.
std::vector<std::array<double, 2>> ends_of(const ImageSet& set) {
  std::vector<std::array<double, 2>> ends;
  for (const ImageSegment& segment : set.segments) {
    ends.push_back({static_cast<double>(segment.low.numerator) / static_cast<double>(segment.low.denominator),
                    static_cast<double>(segment.high.numerator) / static_cast<double>(segment.high.denominator)});
  }
  return ends;
}

double size_of(const scene::PolyPoint& v) {
  return std::sqrt(double(v[0]) * v[0] + double(v[1]) * v[1] + double(v[2]) * v[2]);
}

TEST(LineUnion, VisibleLinesAreTheSetOfPointsDrawn) {
  Dice dice(5);
  const scene::SceneFrame frame = scene::frame_of(scene::PolyCamera{});
  std::size_t coinciding = 0;
  for (int n = 0; n < tests::effort(600, 100); ++n) {
    const scene::PolyScene scene = bricks(dice);
    std::array<double, 3> direction{double(dice(-2, 2)), double(dice(-2, 2)), double(dice(-2, 2))};
    if (direction == std::array<double, 3>{}) direction[0] = 1;
    const scene::PolyCamera camera = scene::camera_outside(frame, scene, direction, n % 3 == 0);
    if (scene::eye_error(scene, camera)) continue;
    const LineLayer layer{"visible", algorithms::exact::visible_edges(scene, camera)};
    const UnitedLines lines = united_lines({&layer, 1}, scene, camera);
    const ImageSet set = image_set(layer.picture, scene, camera);
    ASSERT_EQ(lines.lines.size(), set.segments.size()) << "case " << n;
    coinciding += layer.picture.pieces.size() - set.segments.size();
    // The same ends, in the longer of the coordinates that image_set has: right, or up where right is constant.
    const double forward = camera.perspective ? size_of(camera.forward) : 1;
    const double right = size_of(camera.right) / forward;
    const double up = size_of(camera.up) / forward;
    std::vector<std::array<double, 2>> ends;
    for (const UnitedLine& line : lines.lines) {
      const std::array<double, 2> a{line.from[0] / line.from[2] * right, line.from[1] / line.from[2] * up};
      const std::array<double, 2> b{line.to[0] / line.to[2] * right, line.to[1] / line.to[2] * up};
      const std::size_t axis = std::abs(a[0] - b[0]) > 1e-9 * (1 + std::abs(a[0])) ? 0 : 1;
      ends.push_back({std::min(a[axis], b[axis]), std::max(a[axis], b[axis])});
    }
    const auto expected = ends_of(set);
    // Matched one to one; sorting would depend on the last bit.
    for (const std::array<double, 2>& wanted : expected) {
      const auto found = std::find_if(ends.begin(), ends.end(), [&wanted](const std::array<double, 2>& e) {
        return std::abs(e[0] - wanted[0]) < 1e-9 * (1 + std::abs(wanted[0])) &&
               std::abs(e[1] - wanted[1]) < 1e-9 * (1 + std::abs(wanted[1]));
      });
      ASSERT_NE(found, ends.end()) << "case " << n << ": " << wanted[0] << " to " << wanted[1];
      ends.erase(found);
    }
  }
  EXPECT_GT(coinciding, 500U) << "the cases must have coincident lines";
}

// Visible before hidden, the first layer before others, nothing twice, no points.
TEST(LineUnion, NoStretchIsDrawnTwiceAndNoDashOverlapsALine) {
  Dice dice(6);
  const scene::SceneFrame frame = scene::frame_of(scene::PolyCamera{});
  std::size_t dashes = 0;
  for (int n = 0; n < tests::effort(300, 60); ++n) {
    const scene::PolyScene scene = bricks(dice);
    std::array<double, 3> direction{double(dice(-1, 1)), double(dice(-1, 1)), double(dice(-1, 1))};
    if (direction == std::array<double, 3>{}) direction[1] = 1;
    const scene::PolyCamera camera = scene::camera_outside(frame, scene, direction, n % 2 == 0);
    if (scene::eye_error(scene, camera)) continue;
    const LinePicture seen = algorithms::exact::visible_edges(scene, camera);
    // Visible pieces alternate between two layers.
    std::array<LineLayer, 3> layers{LineLayer{"one", {}}, LineLayer{"two", {}},
                                    hidden_layer(hidden_pieces(wire_frame(scene), seen))};
    for (std::size_t i = 0; i < seen.pieces.size(); ++i) layers[i % 2].picture.pieces.push_back(seen.pieces[i]);
    const UnitedLines lines = united_lines(layers, scene, camera);
    // Any two lines on one line of the image have at most an end in common.
    for (std::size_t i = 0; i < lines.lines.size(); ++i) {
      const UnitedLine& a = lines.lines[i];
      ASSERT_GT(length_of(a), 1e-9);
      ASSERT_GT(a.source_count, 0U);
      dashes += layers[a.layer].hidden ? 1U : 0U;
      const std::array<double, 2> from{a.from[0] / a.from[2], a.from[1] / a.from[2]};
      const std::array<double, 2> to{a.to[0] / a.to[2], a.to[1] / a.to[2]};
      const std::array<double, 2> along{(to[0] - from[0]) / length_of(a), (to[1] - from[1]) / length_of(a)};
      for (std::size_t k = 0; k < i; ++k) {
        const UnitedLine& b = lines.lines[k];
        std::array<double, 2> place{};
        bool on_line = true;
        for (const bool end : {false, true}) {
          const auto& p = end ? b.to : b.from;
          const std::array<double, 2> d{p[0] / p[2] - from[0], p[1] / p[2] - from[1]};
          on_line = on_line && std::abs(d[0] * along[1] - d[1] * along[0]) < 1e-9 * (1 + length_of(a));
          place[end ? 1 : 0] = d[0] * along[0] + d[1] * along[1];
        }
        if (!on_line) continue;
        const double common = std::min(std::max(place[0], place[1]), length_of(a)) - std::max(std::min(place[0], place[1]), 0.0);
        ASSERT_LT(common, 1e-9 * (1 + length_of(a))) << "case " << n;
      }
    }
    // Everything visible is in a visible layer: hidden lines remove nothing.
    const LineLayer visible{"visible", seen};
    double expected = 0;
    for (const UnitedLine& line : united_lines({&visible, 1}, scene, camera).lines) expected += length_of(line);
    double found = 0;
    for (const UnitedLine& line : lines.lines) found += layers[line.layer].hidden ? 0 : length_of(line);
    ASSERT_NEAR(found, expected, 1e-9 * (1 + expected));
  }
  EXPECT_GT(dashes, 500U);
}

// From between the boxes: each edge is drawn where it is in front of the eye and in the window, computed here edge by edge.
TEST(LineUnion, NoLineIsLostAroundTheEye) {
  Dice dice(7);
  std::size_t samples = 0;
  for (int n = 0; n < tests::effort(200, 40); ++n) {
    const scene::PolyScene scene = bricks(dice);
    scene::PolyCamera camera;
    camera.eye = {dice(0, 12) * 5, dice(0, 12) * 5, dice(0, 12) * 5};
    camera.right = {1, 0, 0};
    camera.up = {0, 1, 0};
    camera.forward = {0, 0, 1};
    const LineLayer layer = hidden_layer(wire_frame(scene));
    const std::vector<LineStroke> strokes = strokes_in(united_lines({&layer, 1}, scene, camera), {&layer, 1}, {{-1, -1}, {1, 1}}, {});
    const auto distance_to_strokes = [&strokes](double x, double y) {
      double nearest = 1e9;
      for (const LineStroke& stroke : strokes) {
        const double dx = stroke.to[0] - stroke.from[0];
        const double dy = stroke.to[1] - stroke.from[1];
        const double t = std::clamp(((x - stroke.from[0]) * dx + (y - stroke.from[1]) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
        nearest = std::min(nearest, std::hypot(x - stroke.from[0] - t * dx, y - stroke.from[1] - t * dy));
      }
      return nearest;
    };
    for (const LinePiece& piece : layer.picture.pieces) {
      const scene::PolyPoint& a = scene.vertices[piece.edge.from];
      const scene::PolyPoint& b = scene.vertices[piece.edge.to];
      // An edge seen end-on is omitted.
      const std::array<double, 3> u{double(a[0] - camera.eye[0]), double(a[1] - camera.eye[1]), double(a[2] - camera.eye[2])};
      const std::array<double, 3> v{double(b[0] - camera.eye[0]), double(b[1] - camera.eye[1]), double(b[2] - camera.eye[2])};
      if (u[0] * v[1] == u[1] * v[0] && u[1] * v[2] == u[2] * v[1] && u[2] * v[0] == u[0] * v[2]) continue;
      for (int i = 0; i <= 64; ++i) {
        std::array<double, 3> p{};
        for (std::size_t k = 0; k < 3; ++k) p[k] = u[k] + (v[k] - u[k]) * i / 64;
        // A line that only touches the border of the window is a point.
        if (p[2] <= 0 || std::abs(p[0]) >= p[2] || std::abs(p[1]) >= p[2]) continue;
        ++samples;
        ASSERT_LT(distance_to_strokes(p[0] / p[2], p[1] / p[2]), 1e-7) << "case " << n;
      }
    }
  }
  EXPECT_GT(samples, 10'000U);
}

// Two boxes of the same height side by side, seen from the front: their common edge is one line of two edges, and the top of both
// is one
// line. Computed by hand.
TEST(LineUnion, CoincidentEdgesAreNamedTogether) {
  scene::PolyBuilder builder;
  builder.add_box("left", {0, 0, 0}, {4, 2, 2});
  builder.add_box("right", {4, 0, 0}, {6, 2, 2});
  const scene::PolyScene scene = builder.take();
  scene::PolyCamera camera;
  camera.perspective = false;
  camera.eye = {0, 0, -10};
  const LineLayer layer{"visible", algorithms::exact::visible_edges(scene, camera)};
  const UnitedLines lines = united_lines({&layer, 1}, scene, camera);
  ASSERT_EQ(lines.lines.size(), 5U) << "top, bottom and three uprights";
  for (const UnitedLine& line : lines.lines) {
    const bool level = line.from[1] == line.to[1];
    if (!level) continue;
    EXPECT_EQ(std::abs(line.from[0] - line.to[0]), 6);
    ASSERT_GE(line.source_count, 2U) << "an edge of each box, and those exactly behind them if they are seen";
  }
}

}  // namespace
}  // namespace sightline::picture
