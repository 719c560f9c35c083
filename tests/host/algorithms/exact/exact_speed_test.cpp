// What only an optimised build shows in reasonable time: the oracle's figures on the larger benchmark scenes,
// its limit of a second, `exact` far below it, and both equal on the whole generated set.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <variant>

#include "host/picture/line_picture_image.hpp"
#include "host/scene/generate_scene.hpp"
#include "tests/host/algorithms/exact/edge_scenes.hpp"

namespace sightline::algorithms {
namespace {

struct Timed {
  picture::LinePicture picture;
  std::chrono::duration<double> best{1e9};
};

Timed timed(const Maker& maker, const scene::PolyScene& scene, int runs) {
  Timed timed;
  for (int i = 0; i < runs; ++i) {
    const auto start = std::chrono::steady_clock::now();
    timed.picture = maker.draw(scene, scene.camera);
    const std::chrono::duration<double> needed = std::chrono::steady_clock::now() - start;
    timed.best = std::min(timed.best, needed);
  }
  return timed;
}

TEST(ExactSpeed, TheOracleDrawsAHundredBoxesInASecondAndExactInAFraction) {
  const scene::PolyScene scene = scene::generate_boxes(100);
  const Timed oracle = timed(oracle_maker, scene, 3);
  const Timed exact = timed(exact_maker, scene, 30);
  EXPECT_EQ(oracle.picture.pieces.size(), 818U);
  EXPECT_NEAR(image_length(oracle.picture, scene, scene.camera), 16.266704474, 0.6e-9);
  EXPECT_LT(oracle.best.count(), 1.0);
  EXPECT_LT(exact.best.count(), oracle.best.count() / 10) << "measured: a fiftieth and less";
}

TEST(ExactSpeed, TheOracleDrawsAHundredRooms) {
  const scene::PolyScene scene = scene::generate_rooms(10);
  const picture::LinePicture drawn = oracle_maker.draw(scene, scene.camera);
  EXPECT_EQ(drawn.pieces.size(), 83U);
  EXPECT_NEAR(image_length(drawn, scene, scene.camera), 24.182620501, 0.6e-9);
}

TEST(ExactSpeed, EqualOnTheGeneratedSet) {
  std::uint32_t number = 0;
  for (const scene::GeneratedSceneName& name : scene::generated_set()) {
    const auto scene = std::get<scene::PolyScene>(scene::generate_scene(name.family, name.size, name.seed));
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
