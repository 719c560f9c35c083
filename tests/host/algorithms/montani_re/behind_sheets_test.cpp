// Walls that end on the back of other walls: the lines that the oracle's rule draws there and regions do not.
#include <gtest/gtest.h>

#include "host/algorithms/montani_re/edges_behind_sheets.hpp"
#include "host/algorithms/montani_re/faces.hpp"
#include "host/scene/poly_scene.hpp"

namespace sightline::algorithms::montani_re {
namespace {

// A triangle in z = 0 and a second that ends in the midst of it, on the side of `tip`.
scene::PolyScene touching(std::int32_t tip) {
  scene::PolyScene scene;
  scene.vertices = {{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {1, 1, 0}, {4, 2, 0}, {1, 1, tip}};
  scene.bodies = {{"wall", true, {{{0, 1, 2}, {}}}}, {"partition", true, {{{3, 4, 5}, {}}}}};
  return scene;
}

scene::PolyCamera along_z() {
  scene::PolyCamera camera;
  camera.perspective = false;
  camera.forward = {1, 1, 8};
  camera.right = {8, 0, -1};
  camera.up = {-1, 65, -8};
  return camera;
}

TEST(EdgeBehindSheet, IsNamedIfItIsOnTheFarSide) {
  const auto found = edge_behind_sheet(touching(5), along_z());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->substr(0, 57), "face 0 of body 1 ends on the back of face 0 of body 0, wh");
  EXPECT_EQ(why_not_view(touching(5), along_z()), found);
}

TEST(EdgeBehindSheet, IsNoneOnTheNearSide) {
  EXPECT_FALSE(edge_behind_sheet(touching(-5), along_z()));
}

TEST(EdgeBehindSheet, IsNoneWhereOnlyOutlinesTouch) {
  scene::PolyScene scene = touching(5);
  scene.bodies[1].faces[0].outline = {0, 1, 5};
  EXPECT_FALSE(edge_behind_sheet(scene, along_z()));
}

TEST(EdgeBehindSheet, CountsAnEdgeThatCrossesTheWholeSheet) {
  scene::PolyScene scene = touching(5);
  scene.vertices[3] = {-4, 2, 0};
  scene.vertices[4] = {40, 2, 0};
  EXPECT_TRUE(edge_behind_sheet(scene, along_z()));
}

TEST(EdgeBehindSheet, LeavesHolesAlone) {
  scene::PolyScene scene = touching(5);
  const auto first = static_cast<scene::VertexIndex>(scene.vertices.size());
  scene.vertices.insert(scene.vertices.end(), {{-9, -9, 0}, {-9, 30, 0}, {30, 30, 0}, {30, -9, 0}});
  scene.bodies[0].faces[0] = {{first, first + 3, first + 2, first + 1}, {{0, 2, 1}}};
  EXPECT_FALSE(edge_behind_sheet(scene, along_z()));
}

}  // namespace
}  // namespace sightline::algorithms::montani_re
