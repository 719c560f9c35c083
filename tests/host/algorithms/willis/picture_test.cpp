// Pictures compared with the exact nearest face at each point; and pictures for every choice of representative points.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "host/algorithms/oracle/face_raster.hpp"
#include "host/algorithms/willis/spans.hpp"
#include "host/scene/generate/scene.hpp"
#include "tests/host/algorithms/willis/walls.hpp"

namespace sightline::algorithms::willis {
namespace {

// A level camera along +z whose points have integer sight lines.
struct Setting {
  scene::PolyCamera camera;
  ImageWindow window;
};

Setting setting_at(const scene::PolyPoint& eye, int size) {
  Setting setting;
  setting.camera.eye = eye;
  setting.window = {size, size, size / 2.0, size / 2.0, size / 2.0};
  return setting;
}

// The faces of the bodies before any processing by this algorithm, numbered from 1.
picture::PixelGrid nearest_faces(const scene::PolyScene& scene, const Setting& setting) {
  return oracle::nearest_faces(scene, {setting.camera, setting.window.width, setting.window.width});
}

// Counts points that differ although all points around them are of one face in the true picture.
int wrong_inside(const picture::PixelGrid& truth, const picture::PixelGrid& drawn) {
  int wrong = 0;
  for (int row = 1; row + 1 < truth.height; ++row) {
    for (int column = 1; column + 1 < truth.width; ++column) {
      bool inside = true;
      for (int y = row - 1; y <= row + 1; ++y)
        for (int x = column - 1; x <= column + 1; ++x)
          inside = inside && truth.at(x, y) == truth.at(column, row);
      wrong += inside && truth.at(column, row) != drawn.at(column, row);
    }
  }
  return wrong;
}

int different(const picture::PixelGrid& a, const picture::PixelGrid& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i) count += a.values[i] != b.values[i];
  return count;
}

picture::PixelGrid drawn(const Model& model, const Setting& setting, Representatives representatives = {}) {
  Frames frames(model);
  FrameSpans spans;
  make_spans(model, frames.order(setting.camera, representatives), setting.camera, setting.window, spans);
  return resolve_priorities(spans, setting.window);
}

void expect_exact(const scene::PolyScene& scene, const Setting& setting, const ModelOptions& options = {}) {
  const auto made = make_model(scene, options);
  const Model& model = *made;
  ASSERT_TRUE(model.residual.empty()) << scene.name;
  const picture::PixelGrid truth = nearest_faces(scene, setting);
  const picture::PixelGrid picture = drawn(model, setting);
  EXPECT_EQ(wrong_inside(truth, picture), 0) << scene.name;
  EXPECT_LE(different(truth, picture), 4) << scene.name;  // points on an edge
  std::mt19937 random(3);
  std::vector<std::uint32_t> representatives;
  for (const Surface& s : model.pieces)
    representatives.push_back(static_cast<std::uint32_t>(random() % s.points.size()));
  EXPECT_EQ(drawn(model, setting, representatives), picture) << scene.name;
}

TEST(WillisPicture, ScenesMatchTheNearestFace) {
  expect_exact(scene::generate_boxes(8), setting_at({1013, 987, -1507}, 128));
  expect_exact(scene::generate_town(5), setting_at({1511, 397, -1493}, 128));
  expect_exact(scene::generate_touch(2), setting_at({903, 1107, -1301}, 128));
  expect_exact(scene::generate_rooms(2), setting_at({711, 807, 4003}, 64));
  expect_exact(scene::generate_triangles(8, 3), setting_at({1013, 987, -1507}, 128));
}

TEST(WillisPicture, PrismTownFromWithinInPlan) {
  const scene::PolyScene scene = scene::generate_prisms(20, 4, 60);
  const auto made = make_model(scene, {.plan = true});
  const Model& model = *made;
  ASSERT_TRUE(model.residual.empty());
  const Setting setting = setting_at({9973, 301, -4001}, 128);
  ASSERT_FALSE(plan_error(model, setting.camera));
  EXPECT_EQ(different(nearest_faces(scene, setting), drawn(model, setting)), 0);
}

// At a size at which every gap between pieces would be visible as a hole in a face.
TEST(WillisPicture, NoGapsBetweenPieces) {
  const scene::PolyScene scene = scene::generate_boxes(8);
  const auto made = make_model(scene);
  const Setting setting = setting_at({1013, 987, -1507}, 1500);
  const picture::PixelGrid whole = [&] {
    auto uncut = make_model(scene, {.order_cells = false, .limits = {.depth = 0}});
    return drawn(*uncut, setting);
  }();
  const picture::PixelGrid cut = drawn(*made, setting);
  for (std::size_t i = 0; i < whole.values.size(); ++i)
    EXPECT_EQ(whole.values[i] == 0, cut.values[i] == 0) << i;
}

TEST(WillisPicture, OutlinesAreWhereFacesChange) {
  picture::PixelGrid faces(3, 2);
  faces.values = {1, 1, 2, 1, 1, 1};
  EXPECT_EQ(outlines(faces).values, (std::vector<std::uint32_t>{0, 0, 1, 0, 0, 1}));
}

}  // namespace
}  // namespace sightline::algorithms::willis
