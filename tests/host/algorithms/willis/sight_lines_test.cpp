// A hundred thousand random sight lines through each split model: no wrong order if there are no residual pairs.
#include "host/algorithms/willis/sight_lines.hpp"

#include <gtest/gtest.h>

#include "host/scene/generate/scene.hpp"
#include "tests/host/algorithms/willis/walls.hpp"

namespace sightline::algorithms::willis {
namespace {

void expect_right(const scene::PolyScene& scene, const ModelOptions& options = {}) {
  const auto made = make_model(scene, options);
  ASSERT_TRUE(made) << scene.name;
  EXPECT_TRUE(made->residual.empty()) << scene.name << ' ' << made->residual.size();
  const SightLines lines = count_lines(*made, scene, 100'000, 1);
  EXPECT_GE(lines.with_two, 100'000U) << scene.name;
  EXPECT_EQ(lines.wrong, 0U) << scene.name;
}

TEST(WillisSightLines, PrismTownInPlan) {
  expect_right(scene::generate_prisms(35), {.plan = true});
  expect_right(scene::generate_prisms(35, 2), {.rules = {BoundaryShape::oval, false}, .plan = true});
}

TEST(WillisSightLines, PrismTownInSpace) {
  expect_right(scene::generate_prisms(12, 3, 160));
}

TEST(WillisSightLines, Boxes) {
  expect_right(scene::generate_boxes(12));
}

TEST(WillisSightLines, TouchingCubes) {
  expect_right(scene::generate_touch(3));
}

TEST(WillisSightLines, Rooms) {
  expect_right(scene::generate_rooms(3));
}

}  // namespace
}  // namespace sightline::algorithms::willis
