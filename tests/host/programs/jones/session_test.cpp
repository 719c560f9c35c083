// A session's core for another eye against the program assembled for that eye, word for word; and its runs
// against the twin.
#include "host/programs/jones/session.hpp"

#include <gtest/gtest.h>

#include <string>

#include "host/scene/check/problems.hpp"
#include "tests/firmware/jones_core.hpp"
#include "tests/support/dice.hpp"
#include "tests/support/effort.hpp"

namespace sightline::programs::jones {
namespace {

constexpr int eyes = 50;
constexpr int run_every = 10;

class JonesSession : public testing::TestWithParam<const char*> {
 protected:
  // Anywhere in the scene's box and a little beside it: some of the places are none to stand at.
  geometry::Point random_eye() {
    geometry::Point eye{};
    for (std::size_t a = 0; a < 3; ++a) eye[a] = dice_(scene_.outer.low[a] - 1, scene_.outer.high[a] + 1);
    return eye;
  }

  scene::CellScene scene_ = scene::builtin_scene(GetParam());
  Dice dice_{1};
};

TEST_P(JonesSession, AnotherEyeIsAnotherAssembly) {
  if (scene_.name != "house") NEEDS_OPTIMISED_CODE();
  ProgramOptions options;
  const auto session = Session::of(scene_, options);
  ASSERT_TRUE(session);
  int stood = 0;
  for (int n = 0; n < eyes; ++n) {
    const geometry::Point eye = random_eye();
    const auto core = session->core_at(eye);
    options.tape.view = eye;
    const auto program = assemble_program(scene_, options);
    ASSERT_EQ(core.has_value(), program.has_value());
    if (!core) {
      EXPECT_EQ(core.error(), program.error());
      continue;
    }
    const auto& words = *core;
    ASSERT_EQ(words, program->core) << scene::text_of(eye);
    if (stood++ % run_every != 0) continue;
    GuestOptions guest;
    guest.views = 1;
    guest.display = false;
    const CheckedRun run = session->run(words, guest);
    EXPECT_EQ(run.difference, "") << scene::text_of(eye);
    const GuestRun assembled = run_guest(*program, guest);
    ASSERT_EQ(run.guest.views.size(), 1U);
    ASSERT_EQ(assembled.views.size(), 1U);
    EXPECT_EQ(run.guest.views[0].display_file, assembled.views[0].display_file);
    EXPECT_EQ(run.guest.views[0].time, assembled.views[0].time);
  }
  EXPECT_GT(stood, eyes / 4);
}

TEST_P(JonesSession, ItsTwinKnowsItsModes) {
  for (const unsigned fraction : {0U, 3U}) {
    ProgramOptions options;
    options.eae = fraction == 0;
    options.fraction_bits = fraction;
    options.truncate = fraction == 3;
    const auto session = Session::of(scene_, options);
    ASSERT_TRUE(session);
    GuestOptions guest;
    guest.views = 1;
    guest.display = false;
    guest.scale = 700;
    guest.stereo = fraction == 3;
    guest.immediate = fraction == 0;
    EXPECT_EQ(session->run(guest).difference, "");
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, JonesSession, testing::ValuesIn(scene_names),
                         [](const auto& scene) { return std::string(scene.param); });

TEST(JonesSessionRun, ADifferenceIsNamed) {
  const auto session = Session::of(scene::builtin_scene("house"), {});
  ASSERT_TRUE(session);
  GuestOptions guest;
  guest.views = 1;
  guest.time_limit = core::Duration(1000);
  EXPECT_EQ(session->run(guest).difference, "the program did not complete a view");
}

}  // namespace
}  // namespace sightline::programs::jones
