// The structure of every edge from scratch, compared with the exact picture of the same view by independent code, and with a
// computation in long integers.
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/plantinga/turning_scene.hpp"
#include "host/scene/generate/scene.hpp"
#include "tests/host/algorithms/plantinga/turning_scenes.hpp"

namespace sightline::algorithms::plantinga {
namespace {

void expect_exact(const scene::PolyScene& scene, const Sight& sight) {
  const RotationModel model(scene);
  const picture::LinePicture seen = visible_edges(model, sight);
  EXPECT_TRUE(seen == exact::visible_edges(scene, camera_of(sight)))
      << scene.name << " along " << sight.x << ", " << sight.z;
}

// Directions in line with much of a scene, and random ones.
void expect_exact_all_round(const scene::PolyScene& scene, std::uint32_t seed, int views) {
  for (std::int64_t x = -2; x <= 2; ++x) {
    for (std::int64_t z = -2; z <= 2; ++z) {
      if (x != 0 || z != 0) expect_exact(scene, {x, z});
    }
  }
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> part(-32767, 32767);
  for (int i = 0; i < views; ++i) expect_exact(scene, {part(random), part(random)});
}

TEST(EdgeStructure, EqualsExactOnBoxes) {
  expect_exact_all_round(two_boxes(), 1, 10);
  expect_exact_all_round(three_boxes(), 2, 10);
  expect_exact_all_round(boxes_on_the_ground(), 3, 10);
}

TEST(EdgeStructure, EqualsExactOnGeneratedScenes) {
  for (const char* family : {"boxes", "bricks", "town", "triangles", "rooms"}) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      auto made = scene::generate_scene(family, family == std::string("rooms") ? 1 : 6, seed);
      ASSERT_TRUE(made) << family;
      expect_exact_all_round(*made, static_cast<std::uint32_t>(seed), 5);
    }
  }
}

TEST(EdgeStructure, EqualsExactOnModels) {
  for (const char* name : {"squares", "grid"}) expect_exact_all_round(model_scene(name), 7, 3);
  for (const char* name : {"objects", "bars", "tori"}) {
    const scene::PolyScene scene = model_scene(name);
    for (const Sight& sight : {Sight{0, 1}, Sight{1, 0}, Sight{31415, -2718}}) expect_exact(scene, sight);
  }
}

TEST(EdgeStructure, LongIntegersGiveTheSame) {
  const RotationModel model(three_boxes());
  std::mt19937 random(11);
  std::uniform_int_distribution<int> part(-1000, 1000);
  for (int i = 0; i < 40; ++i) {
    const Direction a = rational_direction(part(random), part(random) * 2 + 1);
    Direction b = rational_direction(a.form.xx * 1000 + a.form.zz, a.form.zz * 1000 - a.form.xx);
    if (compare(a, b) >= 0) continue;
    for (EdgeIndex edge = 0; edge < model.edges().size(); ++edge) {
      const auto occluders = model.occluders_of(edge);
      EXPECT_EQ(wide_structure_between(model, edge, occluders, a, b),
                structure_between(model, edge, occluders, a, b));
    }
  }
}

// Beyond the precision of doubles: between two neighbours of 50 bits.
TEST(EdgeStructure, BetweenDirectionsTooNearForSmallIntegers) {
  const RotationModel model(two_boxes());
  const Int128 f72 = 498454011879264;
  const Int128 f73 = 806515533049393;
  Direction a = rational_direction(f72, f73);
  Direction b = rational_direction(f73, f72 + f73);
  if (compare(a, b) > 0) std::swap(a, b);
  ASSERT_FALSE(sight_between(a, b));
  for (EdgeIndex edge = 0; edge < model.edges().size(); ++edge) {
    const auto occluders = model.occluders_of(edge);
    // No event of two boxes is so close to the golden section.
    EXPECT_EQ(structure_between(model, edge, occluders, a, b),
              structure_at(model, edge, occluders, {10946, 17711}));
  }
}

// Pictures through the list of events, some of them exactly at events.
TEST(TurningScene, DrawsNothingOfAnEdgeSeenEndOn) {
  scene::PolyScene scene;
  scene.vertices = {{1, 0, 0}, {0, 0, 1}, {0, 0, 0}};
  scene.bodies = {{"", true, {{{0, 1, 2}, {}}}}};
  TurningScene turning(scene);
  const picture::LinePicture expected = exact::visible_edges(scene, camera_of({1, 0}));
  EXPECT_TRUE(turning.view({1, 0}) == expected) << "from scratch";
  EXPECT_TRUE(turning.view({1, 0}) == expected) << "through the events";
}

TEST(TurningScene, EqualsExact) {
  std::vector<scene::PolyScene> scenes{two_boxes(), boxes_on_the_ground(), model_scene("grid")};
  for (std::uint64_t seed = 1; seed <= 6; ++seed) scenes.push_back(scene::generate_bricks(6, seed));
  for (const scene::PolyScene& scene : scenes) {
    TurningScene turning(scene);
    std::mt19937 random(3);
    std::uniform_int_distribution<int> part(-32767, 32767);
    for (int i = 0; i < 25; ++i) {
      const Sight sight = i < 8 ? Sight{i % 3 - 1, 1 - i / 4 * 2} : Sight{part(random), part(random)};
      EXPECT_TRUE(turning.view(sight) == exact::visible_edges(scene, camera_of(sight)))
          << scene.name << ' ' << sight.x << ' ' << sight.z;
    }
    EXPECT_TRUE(why_not_view(scene, scene::PolyCamera{}));
    EXPECT_FALSE(why_not_view(scene, camera_of({3, 4})));
    EXPECT_FALSE(why_not(scene));
  }
}

TEST(EdgeStructure, PlacedEndsGiveTheExactPicture) {
  const RotationModel model(three_boxes());
  for (const Sight& sight : {Sight{31415, -2718}, Sight{-777, 12345}, Sight{-20011, -3}}) {
    picture::LinePicture placed;
    for (EdgeIndex edge = 0; edge < model.edges().size(); ++edge) {
      append_pieces(model, edge, structure_at(model, edge, model.occluders_of(edge), sight), sight,
                    placed.pieces);
    }
    EXPECT_TRUE(placed == visible_edges(model, sight));
  }
}

}  // namespace
}  // namespace sightline::algorithms::plantinga
