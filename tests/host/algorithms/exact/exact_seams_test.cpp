// A surface in pieces looks like the surface in one piece when its seams are omitted: the image sets are equal.
#include <gtest/gtest.h>

#include "host/picture/line_picture.hpp"
#include "host/picture/line_picture_image.hpp"
#include "host/scene/generate/scene.hpp"
#include "tests/host/algorithms/exact/edge_scenes.hpp"

namespace sightline::algorithms {
namespace {

using scene::PolyScene;

picture::ImageSet features(const PolyScene& scene, const scene::PolyCamera& camera) {
  return image_set(without_seams(exact::visible_edges(scene, camera), scene, camera), scene, camera);
}

void expect_alike(const PolyScene& pieces, const PolyScene& whole) {
  RandomCameras cameras(whole, 1);
  for (int i = 0; i < 40; ++i) {
    const scene::PolyCamera camera = cameras.outside(i % 2 == 0);
    EXPECT_TRUE(features(pieces, camera) == features(whole, camera)) << i;
    EXPECT_TRUE(image_set(exact::visible_edges(whole, camera), whole, camera) == features(whole, camera))
        << i;
  }
}

// n^3 cubes that touch, all coordinates divided.
PolyScene cubes(std::size_t n, std::int32_t divisor) {
  PolyScene scene = scene::generate_touch(n);
  for (auto& vertex : scene.vertices) {
    for (std::int32_t& c : vertex) c /= divisor;
  }
  return scene;
}

TEST(ExactSeams, ACubeOfCubesThatTouchIsACube) {
  PolyScene whole = cubes(1, 1);
  for (auto& vertex : whole.vertices) {
    for (std::int32_t& c : vertex) c = c == 0 ? 0 : 6;
  }
  expect_alike(cubes(2, 1000 / 3), whole);
  expect_alike(cubes(3, 1000 / 2), whole);
}

TEST(ExactSeams, ATriangulatedCubeIsACube) {
  const PolyScene whole = cubes(1, 100);
  PolyScene triangles = whole;
  std::vector<scene::PolyFace> faces;
  for (const scene::PolyFace& face : whole.bodies[0].faces) {
    ASSERT_EQ(face.outline.size(), 4U);
    faces.push_back({{face.outline[0], face.outline[1], face.outline[2]}, {}});
    faces.push_back({{face.outline[0], face.outline[2], face.outline[3]}, {}});
  }
  triangles.bodies[0].faces = faces;
  expect_alike(triangles, whole);
}

// A wall stands across two coplanar halves of a floor: their joint is a line seen from above, a seam seen from below.
TEST(ExactSeams, AnEdgeMayBeASeamFromOneSideOnly) {
  PolyScene scene;
  scene.vertices = {{0, 0, 0},    {10, 0, 0},  {10, 10, 0}, {0, 10, 0},
                    {-10, 10, 0}, {-10, 0, 0}, {0, 10, 5},  {0, 0, 5}};
  scene.bodies = {{"", true, {{{0, 1, 2, 3}, {}}, {{0, 3, 4, 5}, {}}, {{0, 3, 6, 7}, {}}}}};
  const auto joint = [&scene](const scene::PolyPoint& eye, const scene::PolyPoint& forward) {
    scene::PolyCamera camera{true, eye, forward, {1, 0, 0}, {0, 1, 0}};
    const auto drawn = without_seams(exact::visible_edges(scene, camera), scene, camera);
    return seen_of(drawn, 0, 3).size();
  };
  EXPECT_EQ(joint({4, 5, 30}, {0, 0, -1}), 1U);
  EXPECT_EQ(joint({-4, 5, 30}, {0, 0, -1}), 1U);
  EXPECT_EQ(joint({0, 5, 30}, {0, 0, -1}), 1U) << "in the plane of the wall";
  EXPECT_EQ(joint({4, 5, -30}, {0, 0, 1}), 0U);
  EXPECT_EQ(joint({0, 5, -30}, {0, 0, 1}), 0U);
}

}  // namespace
}  // namespace sightline::algorithms
