// Scenes with faces at equal depth: overlapping coplanar faces, and edges seen end-on. The comparison must not report correct
// results
// there as errors, and must still find errors.
#include <gtest/gtest.h>

#include "host/compare/faces.hpp"
#include "host/compare/turning.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::compare {
namespace {

void add_sheet(scene::PolyScene& scene, const std::vector<scene::PolyPoint>& corners) {
  scene::PolyFace face;
  for (const auto& corner : corners) {
    face.outline.push_back(static_cast<scene::VertexIndex>(scene.vertices.size()));
    scene.vertices.push_back(corner);
  }
  scene.bodies.push_back({"", true, {face}});
}

// Squares 0..10 and 5..15 in the plane z = 0, orthographic along z or in perspective from (7, 7, -10).
scene::PolyScene two_squares(bool perspective) {
  scene::PolyScene scene;
  add_sheet(scene, {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}});
  add_sheet(scene, {{5, 5, 0}, {15, 5, 0}, {15, 15, 0}, {5, 15, 0}});
  scene.camera = {perspective, {7, 7, -10}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
  return scene;
}

TEST(FaceTruth, EachOfTwoFacesInOnePlaneIsRightWhereTheyOverlap) {
  for (const bool perspective : {false, true}) {
    const scene::PolyScene scene = two_squares(perspective);
    const auto truth = FaceTruth::of(scene, scene.camera);
    ASSERT_TRUE(truth) << truth.error().message();
    const auto compared = [&](auto face_at) {
      picture::PixelGrid drawn = truth->faces();
      for (int row = 0; row < drawn.height; ++row)
        for (int column = 0; column < drawn.width; ++column) drawn.set(column, row, face_at(drawn.at(column, row)));
      return truth->compare("drawn", drawn, 0).metrics.different();
    };
    const auto total = [&](std::uint32_t face) {
      std::size_t count = 0;
      for (const std::uint32_t value : truth->faces().values) count += value == face ? 1 : 0;
      return count;
    };
    // The nearest face is the first of equally near faces: 1 shows all of its 100 units of area, 2 shows 75.
    EXPECT_NEAR(static_cast<double>(total(2)) / static_cast<double>(total(1)), 0.75, 0.02);
    EXPECT_EQ(compared([](std::uint32_t face) { return face; }), 0U);
    // Everything as the second face: correct in a quarter of the first one, wrong in its other three.
    const auto wrong = compared([](std::uint32_t face) { return face == 0 ? 0U : 2U; });
    EXPECT_NEAR(static_cast<double>(wrong) / static_cast<double>(total(1)), 0.75, 0.02);
    // As the first one: all of the area that only the second covers is wrong.
    EXPECT_EQ(compared([](std::uint32_t face) { return face == 0 ? 0U : 1U; }), total(2));
  }
}

// A sheet in the plane x = 0 is seen along its edges in z at angles 0 and pi: exact methods have no piece of them there.
TEST(Turning, EdgesSeenEndOnAreNotADifference) {
  scene::PolyScene scene;
  add_sheet(scene, {{0, 0, 0}, {0, 10, 0}, {0, 10, 10}, {0, 0, 10}});
  add_sheet(scene, {{-5, 0, 20}, {5, 0, 20}, {5, 10, 20}, {-5, 10, 20}});
  for (const std::uint32_t angle : {0U, 1U << 17U, 1U << 16U, 3U << 16U}) {
    const auto checked = check_turn(scene, angle);
    ASSERT_TRUE(checked) << checked.error().message();
    EXPECT_EQ(checked->difference, "") << angle;
    EXPECT_TRUE(checked->agrees()) << angle << ": " << checked->distance.greatest << " beyond " << checked->bound;
  }
}

}  // namespace
}  // namespace sightline::compare
