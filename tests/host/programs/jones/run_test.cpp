// A prepared program's core for another eye compared with the program assembled for that eye, word for word; its runs compared
// with the
// twin; and the message of a failed run.
#include "host/programs/jones/jones.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "host/scene/check/problems.hpp"
#include "tests/firmware/jones_core.hpp"
#include "tests/support/dice.hpp"
#include "tests/support/effort.hpp"

namespace sightline::programs::jones {
namespace {

constexpr int eyes = 50;
constexpr int run_every = 10;

class JonesRun : public testing::TestWithParam<const char*> {
 protected:
  // Anywhere in the scene's box and slightly outside: some of the positions are invalid.
  geometry::Point random_eye() {
    geometry::Point eye{};
    for (std::size_t a = 0; a < 3; ++a) eye[a] = dice_(scene_.outer.low[a] - 1, scene_.outer.high[a] + 1);
    return eye;
  }

  scene::CellScene scene_ = scene::builtin_scene(GetParam());
  Dice dice_{1};
};

TEST_P(JonesRun, AnotherEyeGivesAnotherAssembly) {
  if (scene_.name != "house") NEEDS_OPTIMISED_CODE();
  const auto prepared = Prepared::of(scene_);
  ASSERT_TRUE(prepared);
  int stood = 0;
  for (int n = 0; n < eyes; ++n) {
    const geometry::Point eye = random_eye();
    const auto core = prepared->core_at(eye);
    const auto program = assemble_program(scene_, {}, eye);
    ASSERT_EQ(core.has_value(), program.has_value());
    if (!core) {
      EXPECT_EQ(core.error(), program.error());
      continue;
    }
    const auto& words = *core;
    ASSERT_EQ(words, program->core) << scene::text_of(eye);
    if (stood++ % run_every != 0) continue;
    Order order;
    order.eye = eye;
    order.views = 1;
    order.display = false;
    order.check = true;
    const auto there = prepared->run(order);
    ASSERT_TRUE(there) << scene::text_of(eye) << there.error().message();
    order.check = false;
    const Outcome assembled = outcome_of(*program, order);
    ASSERT_EQ(there->views.size(), 1U);
    ASSERT_EQ(assembled.views.size(), 1U);
    EXPECT_EQ(there->views[0].display_file, assembled.views[0].display_file);
    EXPECT_EQ(there->views[0].time, assembled.views[0].time);
  }
  EXPECT_GT(stood, eyes / 4);
}

TEST_P(JonesRun, ItsTwinKnowsItsModes) {
  for (const unsigned fraction : {0U, 3U}) {
    Order order;
    order.views = 1;
    order.display = false;
    order.scale = 700;
    order.stereo = fraction == 3;
    order.immediate = fraction == 0;
    order.check = true;
    const auto outcome = run(scene_, {fraction == 0, fraction, fraction == 3}, order);
    EXPECT_TRUE(outcome) << outcome.error().message();
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, JonesRun, testing::ValuesIn(scene_names),
                         [](const auto& scene) { return std::string(scene.param); });

TEST(JonesRuns, ReportTheFailure) {
  const scene::CellScene house = scene::builtin_scene("house");
  Order order;
  order.views = 1;
  order.time_limit = core::Duration(1000);
  const auto late = run(house, {}, order);
  ASSERT_FALSE(late);
  EXPECT_EQ(late.error().kind, base::ErrorKind::program_failed);
  EXPECT_EQ(late.error().message(), "the program did not complete a view in 0 emulated seconds");
  order.eye = geometry::Point{-10000, 0, 0};
  const auto nowhere = run(house, {}, order);
  ASSERT_FALSE(nowhere);
  EXPECT_EQ(nowhere.error().kind, base::ErrorKind::bad_input);
}

// Compares a view with the twin's view at another scale.
TEST(JonesRuns, NameADifference) {
  const auto prepared = Prepared::of(scene::builtin_scene("house"));
  ASSERT_TRUE(prepared);
  Order order;
  order.views = 1;
  order.display = false;
  const auto outcome = prepared->run(order);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(difference_of(outcome->view(), *prepared->twin(order)), "");
  order.scale = 700;
  EXPECT_TRUE(difference_of(outcome->view(), *prepared->twin(order)).starts_with("word ")) << "of the display file";
}

// At the console the switch for a stereo pair is up, which the twin does not know.
TEST(JonesRuns, CheckOnlyOnRequest) {
  const scene::CellScene house = scene::builtin_scene("house");
  Order order;
  order.views = 1;
  order.display = false;
  order.switches = {{core::Instant{}, core::Word18(1)}};
  EXPECT_TRUE(run(house, {}, order));
  order.check = true;
  const auto checked = run(house, {}, order);
  ASSERT_FALSE(checked);
  EXPECT_EQ(checked.error().kind, base::ErrorKind::differs);
}

// The picture of a view whose lines were added at once is complete: it lights the points of the view computed in the dark.
TEST(JonesRuns, ShowTheCompletePictureOfLinesAddedAtOnce) {
  for (const char* const name : {"house", "roberts", "street4"}) {
    const auto points = [&](bool immediate) {
      Order order;
      order.immediate = immediate;
      const auto outcome = run(scene::builtin_scene(name), {}, order);
      EXPECT_TRUE(outcome) << name;
      std::set<std::pair<int, int>> lit;
      for (const core::Stroke& stroke : outcome->pass) lit.emplace(stroke.x, stroke.y);
      return lit;
    };
    EXPECT_EQ(points(true), points(false)) << name;
  }
}

// A film of lines added at once: what it lights is in the complete picture, and it is lit little by little.
TEST(JonesRuns, FilmLinesThatAreAddedAtOnce) {
  Order order;
  order.views = 1;
  order.immediate = true;
  order.film = true;
  const auto outcome = run(scene::builtin_scene("house"), {}, order);
  ASSERT_TRUE(outcome) << outcome.error().message();
  ASSERT_FALSE(outcome->film.empty());
  std::set<std::pair<int, int>> complete;
  for (const core::Stroke& stroke : outcome->pass) complete.emplace(stroke.x, stroke.y);
  std::vector<std::size_t> lit_by;  // points lit, after each quarter of the time
  std::set<std::pair<int, int>> lit;
  const core::Duration length = outcome->film_end.time_since_epoch();
  auto stroke = outcome->film.begin();
  for (int quarter = 1; quarter <= 4; ++quarter) {
    for (; stroke != outcome->film.end() && stroke->time <= core::Instant(length * quarter / 4); ++stroke) {
      EXPECT_TRUE(complete.contains({stroke->x, stroke->y})) << stroke->x << ',' << stroke->y;
      lit.emplace(stroke->x, stroke->y);
    }
    lit_by.push_back(lit.size());
  }
  EXPECT_EQ(stroke, outcome->film.end());
  for (std::size_t i = 1; i < lit_by.size(); ++i) EXPECT_LT(lit_by[i - 1], lit_by[i]);
  EXPECT_LE(lit_by.back(), complete.size());
  // Without the switch the screen is dark until the picture is complete.
  order.immediate = false;
  const auto dark = run(scene::builtin_scene("house"), {}, order);
  ASSERT_TRUE(dark);
  EXPECT_TRUE(dark->film.empty());
}

// The program need not accept the scene's own view.
TEST(JonesRuns, AreFromAnotherEyeThanTheScenes) {
  scene::CellScene house = scene::builtin_scene("house");
  const geometry::Point eye = house.default_view;
  house.default_view[2] = -1000;
  Order order;
  order.views = 1;
  order.display = false;
  ASSERT_FALSE(run(house, {}, order));
  order.eye = eye;
  const auto outcome = run(house, {}, order);
  ASSERT_TRUE(outcome) << outcome.error().message();
  EXPECT_EQ(outcome->view().display_file, run(scene::builtin_scene("house"), {}, order)->view().display_file);
}

}  // namespace
}  // namespace sightline::programs::jones
