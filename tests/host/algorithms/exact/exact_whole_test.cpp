// Tests that need an optimised build: the oracle's figures on the larger benchmark scenes, and `exact` compared with it on them
// and
// on the whole generated set.
#include <gtest/gtest.h>

#include "host/picture/line_picture_image.hpp"
#include "host/scene/generate/scene.hpp"
#include "tests/host/algorithms/exact/edge_scenes.hpp"
#include "tests/host/scene/generate/generated_set.hpp"

namespace sightline::algorithms {
namespace {

TEST(ExactWhole, TheOracleDrawsAHundredBoxes) {
  const scene::PolyScene scene = scene::generate_boxes(100);
  const picture::LinePicture drawn = oracle_maker.draw(scene, scene.camera);
  EXPECT_EQ(drawn.pieces.size(), 818U);
  EXPECT_NEAR(image_length(drawn, scene, scene.camera), 16.266704474, 0.6e-9);
  EXPECT_TRUE(drawn == exact_maker.draw(scene, scene.camera));
}

TEST(ExactWhole, TheOracleDrawsAHundredRooms) {
  const scene::PolyScene scene = scene::generate_rooms(10);
  const picture::LinePicture drawn = oracle_maker.draw(scene, scene.camera);
  EXPECT_EQ(drawn.pieces.size(), 83U);
  EXPECT_NEAR(image_length(drawn, scene, scene.camera), 24.182620501, 0.6e-9);
}

TEST(ExactWhole, EqualOnTheGeneratedSet) {
  std::uint32_t number = 0;
  for (const scene::GeneratedSceneName& name : scene::generated_set()) {
    const auto scene = *scene::generate_scene(name.family, name.size, name.seed);
    RandomCameras cameras(scene, ++number);
    for (int view = 0; view < 20; ++view) {
      const bool within = view % 5 == 4 && name.family == "rooms";
      const scene::PolyCamera camera = view == 0 ? scene.camera
                                       : within  ? cameras.inside(1000)
                                                 : cameras.outside(view % 2 == 1);
      ASSERT_TRUE(exact_maker.draw(scene, camera) == oracle_maker.draw(scene, camera))
          << scene.name << " view " << view;
    }
  }
}

}  // namespace
}  // namespace sightline::algorithms
