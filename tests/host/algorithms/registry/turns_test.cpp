// All methods that turn a scene through the common interface: their frames equal those of exact, and their results can be saved
// and
// read again.
#include "host/algorithms/registry/turns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "host/algorithms/registry/lines.hpp"
#include "host/scene/generate/scene.hpp"
#include "host/scene/model/poly_builder.hpp"

namespace sightline::registry {
namespace {

scene::PolyScene two_boxes() {
  scene::PolyBuilder builder;
  builder.add_box("left", {-40, 0, -10}, {-10, 30, 20});
  builder.add_box("right", {5, -7, 0}, {35, 41, 40});
  return builder.take();
}

double length_of(const std::vector<TurnLine>& lines) {
  double sum = 0;
  for (const TurnLine& line : lines) sum += std::hypot(line.u1 - line.u0, line.v1 - line.v0);
  return sum;
}

// The length by exact, in the same direction: a camera's image is u and v, times the length of its vectors.
double exact_length(const scene::PolyScene& scene, std::int32_t x, std::int32_t z) {
  const scene::PolyCamera camera{false, {0, 0, 0}, {-x, 0, -z}, {z, 0, -x}, {0, 1, 0}};
  const auto prepared = registry::find_line_algorithm("exact")->prepare(scene);
  const auto view = prepared->view(camera);
  const double scale = std::hypot(x, z);
  double sum = 0;
  for (const picture::LinePiece& piece : view->picture.pieces) {
    const auto& from = scene.vertices[piece.edge.from];
    const auto& to = scene.vertices[piece.edge.to];
    const double u = ((to[0] - from[0]) * double{1} * z - (to[2] - from[2]) * double{1} * x) / scale;
    sum += std::hypot(u, to[1] - from[1]) * (piece.high.to_double() - piece.low.to_double());
  }
  return sum;
}

TEST(TurnMethods, FramesEqualThoseOfExact) {
  const scene::PolyScene scene = two_boxes();
  for (const TurnMethod& method : turn_methods()) {
    ASSERT_FALSE(method.why_not(scene)) << method.name;
    const auto turn = method.prepare(scene, {});
    ASSERT_TRUE(turn) << turn.error().message();
    std::vector<TurnLine> lines;
    for (const auto& [x, z] : {std::pair{31, 200}, {-170, 61}, {99, -40}, {7, 9}}) {
      turn->visible(std::atan2(x, z), lines);
      EXPECT_NEAR(length_of(lines), exact_length(scene, x, z), 1e-9) << method.name << ' ' << x << ':' << z;
    }
    turn->whole(0, lines);
    EXPECT_EQ(lines.size(), 24U);
    EXPECT_EQ(turn->counts[0].value, 24U);
  }
}

// About a slanted axis, seen from above, in both projections: both methods draw the same length. `exact` rounds the eye to the grid,
// or its direction to 15 bits.
TEST(TurnMethods, AgreeOnACircleOfTheEye) {
  scene::PolyScene scene = two_boxes();
  for (scene::PolyPoint& vertex : scene.vertices)
    for (std::int32_t& c : vertex) c *= 1000;
  for (const bool perspective : {false, true}) {
    TurnOptions options;
    options.circle = EyeCircle{{0, 12000, 8000}, {1, 3, -2}, {0, 90000, 150000}, perspective};
    const auto events = find_turn_method("plantinga")->prepare(scene, options);
    const auto views = find_turn_method("exact")->prepare(scene, options);
    ASSERT_TRUE(events) << events.error().message();
    ASSERT_TRUE(views);
    std::vector<TurnLine> lines;
    std::vector<TurnLine> expected;
    for (const double angle : {0.1, 0.7, 1.9, -2.5, 3.1, -0.4}) {  // none at an event
      events->visible(angle, lines);
      views->visible(angle, expected);
      EXPECT_NEAR(length_of(lines), length_of(expected), 20) << angle;
      events->whole(angle, lines);
      views->whole(angle, expected);
      EXPECT_NEAR(length_of(lines), length_of(expected), 1e-6) << angle;
    }
  }
  TurnOptions near;
  near.circle = EyeCircle{{}, {0, 1, 0}, {0, 0, 30000}, true};
  EXPECT_FALSE(find_turn_method("plantinga")->prepare(scene, near));
}

TEST(TurnMethods, SaveTheirResults) {
  const scene::PolyScene scene = two_boxes();
  const TurnMethod& method = *find_turn_method("plantinga");
  const std::string file = testing::TempDir() + "turn.events";
  const auto turn = method.prepare(scene, {});
  ASSERT_TRUE(turn);
  ASSERT_TRUE(turn->keep(file));
  const auto again = method.prepare(scene, {.found = file});
  ASSERT_TRUE(again) << again.error().message();
  EXPECT_EQ(again->counts[1].value, turn->counts[1].value);
  EXPECT_FALSE(method.prepare(scene, {.tolerance = 0.01, .found = file}));
  EXPECT_FALSE(method.prepare(scene::generate_boxes(2), {.found = file}));
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace sightline::registry
