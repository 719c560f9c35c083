// Single sight lines and the faces that they meet, computed by hand.
#include "host/algorithms/oracle/sight_oracle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>

#include "host/algorithms/oracle/face_raster.hpp"
#include "host/scene/generate/scene.hpp"

namespace sightline::algorithms::oracle {
namespace {

// A square of 8 by 8 at z = 10 with a hole of 4 by 4 in its middle, and a whole square behind it at z = 20.
scene::PolyScene frame_before_square() {
  scene::PolyScene scene;
  scene.vertices = {{0, 0, 10}, {0, 8, 10}, {8, 8, 10}, {8, 0, 10}, {2, 2, 10}, {6, 2, 10},
                    {6, 6, 10}, {2, 6, 10}, {0, 0, 20}, {0, 8, 20}, {8, 8, 20}, {8, 0, 20}};
  scene.bodies = {{"square", true, {{{8, 9, 10, 11}, {}}}},
                  {"frame", true, {{{0, 1, 2, 3}, {{4, 5, 6, 7}}}}}};
  return scene;
}

constexpr geometry::Vector3 ahead{0, 0, 1};

TEST(SightOracle, MeetsTheNearestAndPassesThroughHoles) {
  const scene::PolyScene scene = frame_before_square();
  EXPECT_EQ(nearest_face(scene, {{1, 1, 0}, ahead}), (FaceHit{1, 0}));
  EXPECT_EQ(nearest_face(scene, {{4, 4, 0}, ahead}), (FaceHit{0, 0}));
  EXPECT_EQ(nearest_face(scene, {{1, 1, 15}, ahead}), (FaceHit{0, 0}));
  EXPECT_EQ(nearest_face(scene, {{1, 1, 15}, {0, 0, -1}}), (FaceHit{1, 0}));
  EXPECT_FALSE(nearest_face(scene, {{1, 1, 21}, ahead}));
  EXPECT_FALSE(nearest_face(scene, {{9, 1, 0}, ahead}));
  EXPECT_FALSE(nearest_face(scene, {{-1, 1, 10}, {1, 0, 0}})) << "along the frame";
}

TEST(SightOracle, SeesPointsUpToFacesAndThroughHoles) {
  const scene::PolyScene scene = frame_before_square();
  EXPECT_TRUE(sees(scene, {1, 1, 0}, {1, 1, 10})) << "on the face itself";
  EXPECT_FALSE(sees(scene, {1, 1, 0}, {1, 1, 11}));
  EXPECT_TRUE(sees(scene, {4, 4, 0}, {4, 4, 20}));
  EXPECT_FALSE(sees(scene, {4, 4, 0}, {4, 4, 30}));
  EXPECT_TRUE(sees(scene, {1, 1, 0}, {1, 1, -50}));
}

// Through the common side of two triangles, and through their common corner, in either orientation.
TEST(SightOracle, ALineThroughASideMeetsOneOfItsFaces) {
  for (const bool turned : {false, true}) {
    scene::PolyScene scene;
    scene.vertices = {{0, 0, 10}, {8, 0, 10}, {8, 8, 10}, {0, 8, 10}};
    scene.bodies = {{"", true, {{{0, 1, 2}, {}}, {{0, 2, 3}, {}}}}};
    if (turned) scene.bodies[0].faces[1].outline = {3, 2, 0};
    for (const std::int32_t at : {1, 3, 5, 7}) {
      const auto met = nearest_face(scene, {{at, at, 0}, ahead});
      ASSERT_TRUE(met) << at;
      scene::PolyScene without = scene;
      without.bodies[0].faces.erase(without.bodies[0].faces.begin() + static_cast<std::ptrdiff_t>(met->face));
      EXPECT_FALSE(nearest_face(without, {{at, at, 0}, ahead})) << "one side only";
    }
  }
}

// The eye is in front of the middle. The distance of a pixel's sight line from the middle, in the larger direction, decides:
// through
// the hole, on the frame, outside it. Faces are numbered from 1 over all bodies.
TEST(FaceRaster, NumbersTheNearestFaces) {
  scene::PolyScene scene = frame_before_square();
  scene.bodies[0].faces.push_back({{11, 10, 9, 8}, {}});  // number 2, met where number 1 is
  const scene::PolyCamera camera{true, {4, 4, 0}};
  scene::PolyCamera parallel = camera;
  parallel.perspective = false;
  struct Case {
    SquareImage image;
    std::array<std::uint32_t, 5> faces;  // at 1, 3, 5, 7, 9 half pixels from the middle
  };
  for (const auto& [image, faces] :
       {Case{{parallel, 10, 1}, {1, 3, 0, 0, 0}}, Case{{camera, 10, 10}, {1, 3, 0, 0, 0}},
        Case{{camera, 10, 16}, {1, 1, 3, 0, 0}}}) {
    const picture::PixelGrid grid = nearest_faces(scene, image);
    for (int row = 0; row < 10; ++row) {
      for (int column = 0; column < 10; ++column) {
        const int halves = std::max(std::abs(2 * column - 9), std::abs(2 * row - 9));
        EXPECT_EQ(grid.at(column, row), faces[static_cast<std::size_t>(halves / 2)])
            << image.unit << ": " << column << ' ' << row;
      }
    }
  }
}

// Rows count from the bottom, columns along `right`.
TEST(FaceRaster, IsTheRightWayUp) {
  const scene::PolyScene scene = frame_before_square();
  const auto face = [&scene](const scene::PolyCamera& camera, int column, int row) {
    return nearest_faces(scene, {camera, 4, 4}).at(column, row);
  };
  // The frame is to the right of the eye and above it.
  const scene::PolyCamera ahead_of_corner{true, {-2, -2, 6}};
  EXPECT_EQ(face(ahead_of_corner, 3, 3), 2U);
  EXPECT_EQ(face(ahead_of_corner, 0, 3), 0U);
  EXPECT_EQ(face(ahead_of_corner, 3, 0), 0U);
}

// From the middle of a cube every line meets the cube, also through its edges and corners.
TEST(SightOracle, ClosedBodiesHaveNoGaps) {
  const scene::PolyScene walls = scene::generate_aligned(1);  // 250..750
  for (std::int64_t x = -3; x <= 3; ++x)
    for (std::int64_t y = -3; y <= 3; ++y)
      for (std::int64_t z = -3; z <= 3; ++z)
        if (x != 0 || y != 0 || z != 0) {
          EXPECT_TRUE(nearest_face(walls, {{500, 500, 500}, {x, y, z}})) << x << y << z;
        }
}

}  // namespace
}  // namespace sightline::algorithms::oracle
