// The error of frames of a turn, compared with hand computation and with laws.
#include "host/compare/turn_error.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "host/algorithms/plantinga/event_list.hpp"
#include "host/scene/generate/scene.hpp"

namespace sightline::compare {
namespace {

namespace plantinga = algorithms::plantinga;

std::vector<double> around(int frames) {
  std::vector<double> angles;
  for (int i = 0; i < frames; ++i) angles.push_back(-std::numbers::pi + (i + 0.37) * 2 * std::numbers::pi / frames);
  return angles;
}

TEST(TurnError, ExactEventsHaveNoErrorAndJoinedOnesSome) {
  const plantinga::RotationModel model(scene::generate_boxes(5, 3));
  const auto frames = exact_frames(model, around(90));
  const auto exact = plantinga::build_event_list(model, {});
  ASSERT_TRUE(exact);
  const TurnError none = turn_error(model, *exact, frames);
  EXPECT_EQ(none.wrong_frames, 0U);
  EXPECT_NEAR(none.wrong_length, 0, 1e-9 * none.seen_length);
  EXPECT_GT(none.seen_length, 0);
  EXPECT_LT(none.seen_length, none.all_length) << "boxes hide edges";
  plantinga::BuildOptions joined;
  joined.tolerance = 10 * std::numbers::pi / 180;
  const auto late = plantinga::build_event_list(model, joined);
  ASSERT_TRUE(late);
  const TurnError some = turn_error(model, *late, frames);
  EXPECT_GT(some.wrong_frames, 0U);
  EXPECT_GT(some.wrong_length, 0.001 * some.seen_length);
  EXPECT_EQ(some.seen_length, none.seen_length);
}

// A frame half a turn away is a different picture.
TEST(TurnError, TheShownFrameIsTheMeasuredOne) {
  const plantinga::RotationModel model(scene::generate_boxes(5, 3));
  const auto frames = exact_frames(model, around(12));
  const auto list = plantinga::build_event_list(model, {});
  ASSERT_TRUE(list);
  const TurnError away = turn_error(model, *list, frames, [](double angle) { return angle > 0 ? angle - std::numbers::pi : angle + std::numbers::pi; });
  EXPECT_EQ(away.wrong_frames, frames.size());
}

TEST(TurnError, LengthOfPartsIsTheirSum) {
  EXPECT_EQ(length_of({}), 0);
  EXPECT_EQ(length_of({{0, 0.25}, {0.5, 1}}), 0.75);
}

}  // namespace
}  // namespace sightline::compare
