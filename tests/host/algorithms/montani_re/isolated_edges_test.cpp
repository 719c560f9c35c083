// Lines that bound no region: walls that end on the back of other walls, and sheets seen edge-on. `exact` and the oracle draw
// them.
#include "host/algorithms/montani_re/isolated_edges.hpp"

#include <gtest/gtest.h>

#include "tests/host/algorithms/montani_re/agreement.hpp"

namespace sightline::algorithms::montani_re {
namespace {

using picture::LineEdge;

// A triangle in z = 0 and a second one that ends inside it, on the side of `tip`.
scene::PolyScene touching(std::int32_t tip) {
  scene::PolyScene scene;
  scene.name = "touching";
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

picture::LinePicture drawn(const scene::PolyScene& scene, const scene::PolyCamera& camera) {
  return visible_edges(scene, camera)->picture;
}

void expect_agreement(const scene::PolyScene& scene, const scene::PolyCamera& camera) {
  Agreement agreement;
  compare_view(scene, camera, agreement);
  EXPECT_EQ(agreement.first_wrong, "");
}

TEST(IsolatedEdges, OnTheFarSideOfASheetAreSeenThroughIt) {
  const auto edges = isolated_edges(touching(5), along_z());
  EXPECT_EQ(edges, (std::vector<LineEdge>{{3, 4}}));
  EXPECT_EQ(seen_of(drawn(touching(5), along_z()), 3, 4),
            (std::vector<geometry::Interval>{{geometry::Rational{0}, geometry::Rational{1}}}));
  expect_agreement(touching(5), along_z());
}

TEST(IsolatedEdges, AreNoneOnTheNearSide) {
  EXPECT_TRUE(isolated_edges(touching(-5), along_z()).empty());
  expect_agreement(touching(-5), along_z());
}

TEST(IsolatedEdges, AreNoneWhereOnlyOutlinesTouch) {
  scene::PolyScene scene = touching(5);
  scene.bodies[1].faces[0].outline = {0, 1, 5};
  EXPECT_TRUE(isolated_edges(scene, along_z()).empty());
  expect_agreement(scene, along_z());
}

TEST(IsolatedEdges, MayCrossTheWholeSheet) {
  scene::PolyScene scene = touching(5);
  scene.vertices[3] = {-4, 2, 0};
  scene.vertices[4] = {40, 2, 0};
  EXPECT_EQ(isolated_edges(scene, along_z()).size(), 1U);
  expect_agreement(scene, along_z());
}

TEST(IsolatedEdges, MayRunFromCornerToCornerOfTheSheet) {
  scene::PolyScene scene = touching(5);
  const auto first = static_cast<scene::VertexIndex>(scene.vertices.size());
  scene.vertices.insert(scene.vertices.end(), {{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0}});
  scene.bodies[0].faces[0] = {{first, first + 1, first + 2, first + 3}, {}};
  scene.vertices[3] = {-1, -1, 0};
  scene.vertices[4] = {9, 9, 0};
  scene.vertices[5] = {4, 2, 5};
  EXPECT_EQ(isolated_edges(scene, along_z()).size(), 1U);
  expect_agreement(scene, along_z());
}

TEST(IsolatedEdges, DoNotCrossHoles) {
  scene::PolyScene scene = touching(5);
  const auto first = static_cast<scene::VertexIndex>(scene.vertices.size());
  scene.vertices.insert(scene.vertices.end(), {{-9, -9, 0}, {-9, 30, 0}, {30, 30, 0}, {30, -9, 0}});
  scene.bodies[0].faces[0] = {{first, first + 3, first + 2, first + 1}, {{0, 2, 1}}};
  EXPECT_TRUE(isolated_edges(scene, along_z()).empty());
  expect_agreement(scene, along_z());
}

// A face that is behind the sheet at its edge and passes around it to the front elsewhere.
TEST(IsolatedEdges, DependOnTheAdjacentFace) {
  scene::PolyScene scene = touching(5);
  scene.vertices[3] = {1, 2, 0};
  scene.vertices[4] = {3, 2, 0};
  const auto first = static_cast<scene::VertexIndex>(scene.vertices.size());
  scene.vertices.insert(scene.vertices.end(),
                        {{3, 2, 4}, {20, 2, 4}, {20, 2, -4}, {24, 2, -4}, {24, 2, 8}, {1, 2, 8}});
  scene.bodies[1].faces[0] = {{3, 4, first, first + 1, first + 2, first + 3, first + 4, first + 5}, {}};
  EXPECT_EQ(isolated_edges(scene, along_z()).size(), 1U);
  expect_agreement(scene, along_z());
}

// A box stands on the back, too, and another is in front of all.
TEST(IsolatedEdges, AreHiddenByNearerFaces) {
  scene::PolyScene scene = touching(5);
  add_sheet(scene, {{2, 0, -3}, {3, 0, -3}, {3, 9, -2}, {2, 9, -2}});
  expect_agreement(scene, along_z());
  EXPECT_EQ(seen_of(drawn(scene, along_z()), 3, 4).size(), 2U);
}

TEST(IsolatedEdges, OfASheetSeenEdgeOn) {
  scene::PolyScene scene;
  scene.name = "edge-on";
  add_sheet(scene, {{-8, 1, 10}, {8, 1, 10}, {8, 1, 30}, {-8, 1, 30}},
            {{-4, 1, 12}, {-4, 1, 20}, {4, 1, 20}, {4, 1, 12}});
  add_sheet(scene, {{1, -8, 11}, {1, 8, 11}, {1, 8, 31}, {1, -8, 31}});
  add_sheet(scene, square(3, 5));
  add_sheet(scene, {{-20, -20, 50}, {20, -20, 50}, {20, 25, 50}, {-20, 20, 50}});
  for (const bool perspective : {false, true}) {
    for (const scene::PolyPoint& eye :
         {scene::PolyPoint{0, 1, 0}, {1, 0, 0}, {-3, 1, 0}, {1, 1, 0}, {-9, 1, 15}}) {
      expect_agreement(scene, {perspective, eye, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}});
      expect_agreement(scene, {perspective, eye, {0, 0, 1}, {1, 1, 0}, {-1, 1, 0}});
      expect_agreement(scene, {perspective, eye, {1, 0, 0}, {0, 0, -1}, {0, 1, 0}});
    }
  }
}

// A sheet in the plane of the eye, behind two sheets that share a side there or behind one whose outline is there: the far sheet
// is
// not drawn, and the picture equals that of `exact`, which has the outline. Beyond the end of the outline the far sheet is drawn.
TEST(IsolatedEdges, ExactlyBehindAnOutlineAreNotDrawn) {
  for (const bool both : {true, false}) {
    scene::PolyScene scene;
    scene.name = "seam";
    scene.vertices = {{0, -9, 10}, {0, 9, 10}, {9, 9, 10}, {9, -9, 10}, {-9, 9, 10}, {-9, -9, 10}, {0, -3, 20}, {0, 3, 20}, {0, 3, 30}, {0, -3, 30}};
    scene.bodies = {{"right", true, {{{0, 1, 2, 3}, {}}}}, {"edge-on", true, {{{6, 7, 8, 9}, {}}}}};
    if (both) scene.bodies.push_back({"left", true, {{{0, 1, 4, 5}, {}}}});
    const scene::PolyCamera camera;  // at the origin, along z
    const auto near = [&] {
      std::size_t pieces = 0;
      for (const picture::LinePiece& piece : drawn(scene, camera).pieces) pieces += piece.edge.from >= 6 ? 1 : 0;
      return pieces;
    };
    EXPECT_EQ(near(), 0U) << both;
    expect_agreement(scene, camera);
    scene.vertices[7] = {0, 30, 20};  // above the outline, whose end appears at y = 18
    EXPECT_GT(near(), 0U) << both;
    expect_agreement(scene, camera);
  }
}

}  // namespace
}  // namespace sightline::algorithms::montani_re
