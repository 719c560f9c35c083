// Edges of a scene, and images of line pictures merged and measured, compared with values computed by hand.
#include "host/picture/line_picture.hpp"

#include <gtest/gtest.h>

#include "host/picture/line_picture_image.hpp"

namespace sightline::picture {
namespace {

using geometry::Int128;
using geometry::Rational;
using scene::PolyScene;

constexpr Int128 big = Int128{1} << 99;

TEST(LinePicture, EdgesAreNamedOnceForAllTheirFaces) {
  PolyScene scene;
  scene.vertices.resize(6);
  scene.bodies = {{"", false, {{{0, 1, 2}, {}}, {{2, 1, 3}, {}}}}, {"", true, {{{3, 5, 4}, {{1, 0, 0}}}}}};
  const std::vector<LineEdge> expected{{0, 1}, {0, 2}, {1, 2}, {1, 3}, {2, 3}, {3, 4}, {3, 5}, {4, 5}};
  EXPECT_EQ(edges_of(scene), expected);
}

TEST(ImageRatio, OrderIsExactAtAHundredBits) {
  EXPECT_LT(compare({big, big + 1}, {big + 1, big + 2}), 0);
  EXPECT_GT(compare({-big, big + 1}, {-big - 1, big + 2}), 0);
  EXPECT_EQ(compare({big, big + 1}, {big, big + 1}), 0);
  EXPECT_LT(compare({-1, 2}, {1, 3}), 0);
  EXPECT_GT(compare({5, 2}, {2, 1}), 0);
  EXPECT_LT(compare({2, 1}, {5, 2}), 0);
  EXPECT_LT(compare({big, 1}, {1, 0}), 0);
  EXPECT_LT(compare({-1, 0}, {-big, 1}), 0);
  EXPECT_EQ(compare({1, 0}, {1, 0}), 0);
}

// Seen along z from the origin. Vertices 0-1 and 2-3 are on one image line, 4-5 on another.
PolyScene two_lines() {
  PolyScene scene;
  scene.vertices = {{-10, 5, 10}, {10, 5, 10}, {0, 10, 20}, {40, 10, 20}, {3, -1, 1}, {3, 1, 1}};
  return scene;
}

TEST(ImageSet, CollinearPiecesMergeAcrossDepths) {
  const PolyScene scene = two_lines();
  const LinePicture picture{{{{0, 1}, {1, 4}, {3, 4}}, {{2, 3}, {0}, {1}}, {{4, 5}, {0}, {1}}}};
  const ImageSet set = image_set(picture, scene, scene.camera);
  ASSERT_EQ(set.segments.size(), 2U);
  // x from -5/10 to 40/20 on y = 1/2; y from -1 to 1 on x = 3.
  EXPECT_EQ(set.segments[0].line, (std::array<std::int64_t, 4>{0, 2, -1, 0}));
  EXPECT_EQ(set.segments[0].low, (ImageRatio{-1, 2}));
  EXPECT_EQ(set.segments[0].high, (ImageRatio{2, 1}));
  EXPECT_EQ(set.segments[1].line, (std::array<std::int64_t, 4>{1, 0, -3, 0}));
  EXPECT_EQ(set.segments[1].low, (ImageRatio{-1, 1}));
  EXPECT_EQ(set.segments[1].high, (ImageRatio{1, 1}));
}

TEST(ImageSet, IsTheSameForTheSamePointsOfOtherEdges) {
  PolyScene scene = two_lines();
  const LinePicture two{{{{0, 1}, {0}, {1, 2}}, {{0, 1}, {3, 4}, {1}}, {{2, 3}, {0}, {1, 4}}}};
  const LinePicture one{{{{0, 1}, {0}, {1}}}};
  EXPECT_EQ(image_set(two, scene, scene.camera), image_set(one, scene, scene.camera));
  const LinePicture less{{{{0, 1}, {0}, {999, 1000}}}};
  EXPECT_NE(image_set(less, scene, scene.camera), image_set(one, scene, scene.camera));
  scene.camera.perspective = false;
  EXPECT_NE(image_set(two, scene, scene.camera), image_set(one, scene, scene.camera));
}

TEST(ImageSet, APieceThatEndsInThePlaneOfTheEyeRunsToInfinity) {
  PolyScene scene;
  scene.vertices = {{1, 2, 0}, {1, 2, 4}};
  const ImageSet set = image_set({{{{0, 1}, {0}, {1}}}}, scene, scene.camera);
  ASSERT_EQ(set.segments.size(), 1U);
  EXPECT_EQ(set.segments[0].low, (ImageRatio{1, 4}));
  EXPECT_EQ(set.segments[0].high, (ImageRatio{1, 0}));
}

TEST(ImageSet, ALineSeenEndOnIsOmitted) {
  PolyScene scene;
  scene.vertices = {{1, 2, 3}, {2, 4, 6}};
  EXPECT_TRUE(image_set({{{{0, 1}, {0}, {1}}}}, scene, scene.camera).segments.empty());
}

TEST(ImageLength, IsInTheImagePlaneAtUnitFocalLengthForVectorsOfAnyLength) {
  PolyScene scene = two_lines();
  scene.camera.forward = {0, 0, 7};
  scene.camera.right = {3, 0, 0};
  scene.camera.up = {0, 2, 0};
  const LinePicture picture{{{{0, 1}, {1, 4}, {3, 4}}, {{4, 5}, {0}, {1, 2}}}};
  EXPECT_DOUBLE_EQ(image_length(picture, scene, scene.camera), 1.0 + 1.0);
  scene.camera.perspective = false;
  EXPECT_DOUBLE_EQ(image_length(picture, scene, scene.camera), 10.0 + 1.0);
}

}  // namespace
}  // namespace sightline::picture
