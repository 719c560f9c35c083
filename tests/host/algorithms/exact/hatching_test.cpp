// Hatching, and crossing lines between bodies of scenes without surfaces: `exact` compared with the oracle, and laws of the
// positions of the lines.
#include "host/picture/hatching.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "host/algorithms/exact/edge_mesh.hpp"
#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/oracle/edge_oracle.hpp"
#include "host/picture/line_drawing.hpp"
#include "host/scene/check/crossings.hpp"
#include "host/scene/check/poly_scene.hpp"
#include "host/scene/generate/scene.hpp"
#include "host/scene/model/aim_camera.hpp"
#include "host/scene/model/eye_place.hpp"
#include "host/scene/model/face_cut.hpp"
#include "tests/support/dice.hpp"

namespace sightline::algorithms {
namespace {

using Dice = programs::jones::Dice;
using scene::PolyPoint;
using scene::VertexIndex;

void add_box(scene::PolyScene& scene, const PolyPoint& low, const PolyPoint& high) {
  const auto first = static_cast<VertexIndex>(scene.vertices.size());
  for (int i = 0; i < 8; ++i)
    scene.vertices.push_back({(i & 1) != 0 ? high[0] : low[0], (i & 2) != 0 ? high[1] : low[1], (i & 4) != 0 ? high[2] : low[2]});
  scene::PolyBody& body = scene.bodies.emplace_back();
  for (const auto& face : std::vector<std::vector<VertexIndex>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    body.faces.emplace_back();
    for (const VertexIndex v : face) body.faces.back().outline.push_back(first + v);
  }
}

// Random boxes, most of which pass through others, and a sheet through all of them.
scene::PolyScene crossing_boxes(Dice& dice, int count) {
  scene::PolyScene scene;
  for (int i = 0; i < count; ++i) {
    PolyPoint low{};
    PolyPoint high{};
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = dice(-60, 20);
      high[a] = low[a] + dice(15, 60);
    }
    add_box(scene, low, high);
  }
  scene::PolyBody& sheet = scene.bodies.emplace_back();
  sheet.sheet = true;
  const auto first = static_cast<VertexIndex>(scene.vertices.size());
  for (const PolyPoint& p : {PolyPoint{-70, -30, -70}, {70, -30, -70}, {70, 30, 70}, {-70, 30, 70}}) scene.vertices.push_back(p);
  sheet.faces.push_back({{first, first + 1, first + 2, first + 3}, {}});
  return scene;
}

std::optional<scene::PolyCamera> camera_around(const scene::PolyScene& scene, Dice& dice, bool perspective) {
  const std::array<double, 3> direction{dice(-100, 100) / 100.0, dice(-100, 100) / 100.0, dice(-99, 100) / 100.0 + 0.005};
  scene::PolyCamera camera = scene::camera_outside({}, scene, direction, perspective);
  if (scene::eye_error(scene, camera)) return std::nullopt;
  return camera;
}

struct Hatched {
  picture::Hatching hatching;
  scene::PolyCamera camera;
  picture::ImageWindow window;
  double units = 1;
};

// For a drawing of 100 by 100.
Hatched hatch(const scene::PolyScene& scene, const scene::PolyCamera& camera, const picture::HatchOptions& options) {
  Hatched result;
  result.camera = camera;
  const picture::DrawingField field{100, 100, {}};
  const picture::LineLayer edges{"", exact::visible_edges(scene, camera)};
  result.window = picture::drawing_window(picture::united_lines({&edges, 1}, scene, camera), camera, field);
  result.units = 100 / (result.window.high[0] - result.window.low[0]);
  auto hatching = picture::hatch(scene, camera, result.window, result.units, options);
  EXPECT_TRUE(hatching);
  if (hatching) result.hatching = std::move(*hatching);
  return result;
}

picture::LinePicture seen(const Hatched& hatched) {
  return exact::visible_edges(exact::make_edge_mesh(hatched.hatching.scene), hatched.camera, &hatched.hatching.lines);
}

TEST(Hatching, ExactAndOracleSeeTheSame) {
  Dice dice(31);
  std::size_t lines = 0;
  std::size_t pieces = 0;
  for (const std::string family : {"boxes", "prisms", "triangles", "town", "crossing"}) {
    for (int i = 0; i < 15; ++i) {
      const auto generated = family == "crossing"
                                 ? crossing_boxes(dice, 4)
                                 : *scene::generate_scene(family, 7, 100U + static_cast<unsigned>(i));
      const auto camera = camera_around(generated, dice, i % 3 != 0);
      if (!camera) continue;
      const Hatched made =
          hatch(generated, *camera,
                {dice(0, 180) * 1.0, 4, {dice(-9, 9) + 0.5, dice(-9, 9) + 0.5, dice(-9, 9) + 0.5}});
      const picture::LinePicture fast = seen(made);
      EXPECT_TRUE(fast == oracle::visible_edges(made.hatching.scene, made.camera, made.hatching.lines)) << family << ' ' << i;
      lines += made.hatching.lines.edges.size();
      pieces += fast.pieces.size();
    }
  }
  EXPECT_GT(lines, 4000U);
  EXPECT_GT(pieces, 2000U);
}

// On the paper: at the angle, at integer multiples of the spacing; in space: on their faces, within rounding.
TEST(Hatching, LinesHaveTheRequestedAngleAndSpacing) {
  Dice dice(7);
  for (int i = 0; i < 6; ++i) {
    const auto scene = *scene::generate_scene("boxes", 5, 10U + static_cast<unsigned>(i));
    const auto camera = camera_around(scene, dice, i % 2 == 0);
    if (!camera) continue;
    const double degrees = dice(0, 179);
    const picture::HatchOptions options{degrees, 2, {0.3, 0.2, -0.9}};
    const Hatched made = hatch(scene, *camera, options);
    const auto& vertices = made.hatching.scene.vertices;
    const picture::DrawingField field{100, 100, {}};
    std::vector<const scene::PolyFace*> faces;
    for (const scene::PolyBody& body : made.hatching.scene.bodies)
      for (const scene::PolyFace& face : body.faces) faces.push_back(&face);
    for (std::size_t l = 0; l < made.hatching.lines.edges.size(); ++l) {
      const picture::LineEdge& edge = made.hatching.lines.edges[l];
      const picture::LineLayer layer{"", {{{edge, 0, 1}}}};
      const picture::UnitedLines united = picture::united_lines({&layer, 1}, made.hatching.scene, made.camera);
      const auto strokes = picture::strokes_in(united, {&layer, 1}, made.window, field);
      const picture::VectorDrawing drawing = picture::line_drawing(strokes, {&layer, 1}, made.window, field);
      if (drawing.points.size() != 2) continue;  // outside of the window
      const double angle = (degrees + (made.hatching.directions[l] == picture::HatchDirection::across ? 90 : 0)) * std::numbers::pi / 180;
      for (const picture::DrawingPoint& p : drawing.points) {
        const double at = (-std::sin(angle) * p.x + std::cos(angle) * p.y) / options.spacing;
        EXPECT_NEAR(at, std::round(at), 1e-4);  // coordinates of the drawing are in single precision
      }
      const scene::PolyFace& face = *faces[made.hatching.scene.crossings[l].face_a];
      const auto normal = geometry::normal_of(vertices[face.outline[0]], vertices[face.outline[1]], vertices[face.outline[2]]);
      const double length =
          std::sqrt(double(normal[0]) * double(normal[0]) + double(normal[1]) * double(normal[1]) +
                    double(normal[2]) * double(normal[2]));
      for (const VertexIndex v : {edge.from, edge.to}) {
        const auto end = scene::place_of(made.hatching.scene, v);
        double off = 0;
        for (std::size_t a = 0; a < 3; ++a) off += double(normal[a]) * (end[a] - vertices[face.outline[0]][a]);
        EXPECT_NEAR(off / length, 0, 1e-9);
      }
    }
  }
}

// A square of 80 by 80 in the middle of the paper, seen from the front: the amount of ink does not depend on the angle.
TEST(Hatching, InkIsAreaBySpacing) {
  scene::PolyScene scene;
  scene::PolyBody& body = scene.bodies.emplace_back();
  body.sheet = true;
  scene.vertices = {{0, 0, 0}, {80, 0, 0}, {80, 80, 0}, {0, 80, 0}};
  body.faces.push_back({{0, 1, 2, 3}, {}});
  scene::PolyCamera camera;
  camera.perspective = false;
  camera.eye = {0, 0, -100};
  for (const double degrees : {0.0, 30.0, 45.0, 117.0}) {
    struct Case {
      std::array<double, 3> light;
      double density;
    };
    for (const Case& c : {Case{{0, 0, -1}, 0}, Case{{0, 1, -1}, 0.25}, Case{{0, 2, -1}, 0.5},
                          Case{{0, 4, -1}, 1}, Case{{0, 1, 0}, 1.5}, Case{{0, 0, 1}, 1.5}}) {
      const Hatched made = hatch(scene, camera, {degrees, 1, c.light});
      double length = 0;
      for (const picture::LineEdge& edge : made.hatching.lines.edges) {
        const auto p = scene::place_of(made.hatching.scene, edge.from);
        const auto q = scene::place_of(made.hatching.scene, edge.to);
        length += std::hypot(p[0] - q[0], p[1] - q[1]);
      }
      // The square is as wide as the paper: 100.
      length *= made.units;
      EXPECT_NEAR(length, c.density * 100 * 100, 4 * 100 * (c.density > 0 ? 1.2 : 0)) << degrees;
    }
  }
}

TEST(Hatching, MoreLightIsNeverDarker) {
  int before = static_cast<int>(picture::tone_of(-1));
  EXPECT_EQ(before, static_cast<int>(picture::Tone::crossed));
  for (int i = -100; i <= 100; ++i) {
    const int tone = static_cast<int>(picture::tone_of(i / 100.0));
    EXPECT_LE(tone, before);
    before = tone;
  }
  EXPECT_EQ(before, static_cast<int>(picture::Tone::light));
}

TEST(Hatching, AHoleHasNone) {
  scene::PolyScene scene;
  scene::PolyBody& body = scene.bodies.emplace_back();
  body.sheet = true;
  scene.vertices = {{0, 0, 0}, {80, 0, 0}, {80, 80, 0}, {0, 80, 0}, {20, 20, 0}, {20, 60, 0}, {60, 60, 0}, {60, 20, 0}};
  body.faces.push_back({{0, 1, 2, 3}, {{4, 5, 6, 7}}});
  ASSERT_TRUE(scene::check_poly_scene(scene).empty());
  scene::PolyCamera camera;
  camera.perspective = false;
  camera.eye = {0, 0, -100};
  const Hatched made = hatch(scene, camera, {45, 3, {0, 1, 0}});
  ASSERT_FALSE(made.hatching.lines.edges.empty());
  for (const picture::LineEdge& edge : made.hatching.lines.edges) {
    for (int i = 1; i < 20; ++i) {
      const double t = i / 20.0;
      const auto p = scene::place_of(made.hatching.scene, edge.from);
      const auto q = scene::place_of(made.hatching.scene, edge.to);
      const double x = p[0] + t * (q[0] - p[0]);
      const double y = p[1] + t * (q[1] - p[1]);
      EXPECT_FALSE(x > 20 + 1e-9 && x < 60 - 1e-9 && y > 20 + 1e-9 && y < 60 - 1e-9);
    }
  }
}

// Lines in which bodies of a scene without surfaces cross.
TEST(CrossingsWithoutSurfaces, ExactAndOracleSeeTheSame) {
  Dice dice(11);
  std::size_t pieces = 0;
  std::size_t crossings = 0;
  for (int i = 0; i < 40; ++i) {
    const scene::PolyScene given = crossing_boxes(dice, 5);
    const auto camera = camera_around(given, dice, i % 2 == 0);
    if (!camera) continue;
    const scene::PolyScene scene = scene::with_crossings(given);
    const picture::ChosenEdges chosen = picture::EdgeChooser(scene, *picture::edge_choice_named("all")).at(*camera);
    const picture::LinePicture fast = exact::visible_edges(exact::make_edge_mesh(scene), *camera, &chosen);
    EXPECT_TRUE(fast == oracle::visible_edges(scene, *camera, chosen)) << i;
    // The visible parts of the edges are the same without the lines.
    picture::LinePicture edges;
    const VertexIndex first = scene.crossings.empty() ? static_cast<VertexIndex>(scene.vertices.size())
                                                      : scene.crossings.front().from;
    std::copy_if(fast.pieces.begin(), fast.pieces.end(), std::back_inserter(edges.pieces),
                 [first](const picture::LinePiece& piece) { return piece.edge.from < first; });
    EXPECT_TRUE(edges == exact::visible_edges(given, *camera)) << i;
    crossings += scene.crossings.size();
    pieces += fast.pieces.size() - edges.pieces.size();
  }
  EXPECT_GT(crossings, 500U);
  EXPECT_GT(pieces, 100U);
}

}  // namespace
}  // namespace sightline::algorithms
