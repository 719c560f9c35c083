// Jones's program on the emulated PDP-7 with its display: the default view of every scene, its cost and its picture.
// tests/firmware/jones_control_test.cpp tests switches, statuses and lines added at once.
#include "host/programs/jones/jones.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <tuple>

#include "tests/firmware/jones_drawn_points.hpp"
#include "tests/firmware/jones_path_watch.hpp"
#include "tests/firmware/jones_scenes.hpp"
#include "tests/host/programs/jones/drawing.hpp"

namespace sightline::programs::jones {
namespace {

class JonesGuest : public testing::TestWithParam<std::tuple<const char*, bool>> {
 protected:
  JonesGuest() : program(assemble_jones(scene(), eae())), run(outcome_of(program)) {}
  static std::string scene() { return std::get<0>(GetParam()); }
  static bool eae() { return std::get<1>(GetParam()); }

  Program program;
  Outcome run;
};

TEST_P(JonesGuest, EveryViewEqualsTheTwins) {
  const TwinView expected = twin_view(program);
  ASSERT_EQ(expected.status, Status::complete);
  ASSERT_EQ(run.views.size(), 2U);
  for (const View& view : run.views) {
    EXPECT_EQ(name(view.status), name(Status::complete));
    EXPECT_TRUE(same_words(view.display_file, expected.display_file));
    EXPECT_EQ(view.visits, expected.counts.visits);
    EXPECT_EQ(view.openings_tested, expected.counts.openings_tested);
    // The machine skips lines of openings whose box does not meet the mask.
    EXPECT_LE(view.lines_clipped, expected.counts.lines_clipped);
    EXPECT_GE(view.lines_clipped, expected.counts.pieces);
    EXPECT_EQ(view.pieces, expected.counts.pieces);
    EXPECT_EQ(view.distinct_cells, expected.counts.distinct_cells);
  }
}

// Without a display another watch counts. A display only adds its interrupts.
TEST_P(JonesGuest, AViewWithoutADisplayIsCountedAlike) {
  for (const bool immediate : {false, true}) {
    Order order;
    order.immediate = immediate;
    order.clock = false;
    order.views = 1;
    const Outcome with = outcome_of(program, order);
    order.display = false;
    const Outcome without = outcome_of(program, order);
    ASSERT_EQ(with.views.size(), 1U);
    ASSERT_EQ(without.views.size(), 1U);
    const View& a = with.views[0];
    const View& b = without.views[0];
    EXPECT_GT(a.instructions, 1000U);
    EXPECT_LE(b.instructions, a.instructions);
    EXPECT_GT(b.instructions, a.instructions / 10 * 9);
    EXPECT_LE(b.time, a.time);
    EXPECT_GT(b.time, a.time / 10 * 9);
    EXPECT_EQ(a.visits, b.visits);
    EXPECT_EQ(a.openings_tested, b.openings_tested);
    EXPECT_EQ(a.lines_clipped, b.lines_clipped);
    EXPECT_EQ(a.pieces, b.pieces);
    EXPECT_EQ(a.distinct_cells, b.distinct_cells);
    EXPECT_TRUE(same_words(a.display_file, b.display_file));
  }
}

// "A few seconds", and less with efficient code: view 2, while the display shows the previous picture.
TEST_P(JonesGuest, TakesNoLongerThanItMay) {
  ASSERT_EQ(run.views.size(), 2U);
  const auto seconds = [](core::Duration time) { return core::in_seconds(time); };
  std::printf("%-10s %-11s view 1 %.4f s, view 2 %.4f s, %llu instructions\n", scene().c_str(),
              eae() ? "with EAE" : "without EAE", seconds(run.views[0].time), seconds(run.views[1].time),
              static_cast<unsigned long long>(run.views[1].instructions));
  EXPECT_LE(seconds(run.views[1].time), eae() ? 1.0 : 6.0);
  const auto ticks = [&](const View& view) {
    return static_cast<std::uint64_t>(seconds(view.time) * 50) + 1;
  };
  EXPECT_LE(run.views[0].stolen_cycles, ticks(run.views[0])) << "the display is dark: only the clock steals";
  EXPECT_GT(run.views[1].stolen_cycles, ticks(run.views[1]));
}

// Point for point, repeatedly.
TEST_P(JonesGuest, ThePictureMatchesTheWords) {
  EXPECT_EQ(points_of(run.pass), drawn_points(twin_view(program).display_file));
  for (const core::Stroke& stroke : run.pass) ASSERT_EQ(stroke.intensity, 7);
  EXPECT_GT(run.refresh_period.count(), 0);
  ASSERT_FALSE(run.pass.empty());
  EXPECT_LT(run.pass.back().time - run.pass.front().time, run.refresh_period);
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, JonesGuest,
                         testing::Combine(testing::ValuesIn(scene_names), testing::Bool()),
                         [](const auto& p) {
                           return std::string(std::get<0>(p.param)) +
                                  (std::get<1>(p.param) ? "_WithEae" : "_WithoutEae");
                         });

// In a row of rooms the search enters only the visible ones, for any number of rooms.
TEST(JonesGuestCells, InvisibleRoomsAreNeverEntered) {
  Outcome runs[2];
  for (int i = 0; i < 2; ++i) {
    runs[i] = outcome_of(assemble_jones(i == 0 ? "corridor8" : "corridor32", true));
    ASSERT_EQ(runs[i].views.size(), 2U);
    EXPECT_EQ(runs[i].views[1].distinct_cells, 5U);
  }
  EXPECT_EQ(runs[0].views[0].display_file, runs[1].views[0].display_file);
}

// For any contents of core at power-on.
TEST(JonesGuestCore, TheInitialContentsOfCoreHaveNoEffect) {
  const Program program = assemble_jones("roberts", true);
  const TwinView expected = twin_view(program);
  core::Duration times[2]{};
  for (std::uint64_t fill = 0; fill < 2; ++fill) {
    PathWatch watch(program, false);
    pdp7::Machine machine;
    ASSERT_EQ(machine.attach("display"), "");
    machine.randomise_core(1971 + fill);
    machine.load(0, program.core);
    machine.start(program.labels.start);
    for (int view = 0; view < 2; ++view) {
      pdp7::Limits limits;
      limits.until = core::Instant(core::seconds(60));
      ASSERT_EQ(machine.run(limits, watch), pdp7::StopReason::observer);
      EXPECT_EQ(machine.peek(program.labels.status).value(), 0U);
      EXPECT_TRUE(same_words(file_words(machine, program), expected.display_file));
    }
    times[fill] = watch.time();
  }
  EXPECT_EQ(times[0], times[1]);
}

std::vector<ScreenSegment> pieces_of(const View& view) {
  TwinView words;
  words.display_file = view.display_file;
  const Drawing drawing = decode(words);
  EXPECT_TRUE(drawing.well_formed);
  return drawing.pieces;
}

TEST(JonesGuestStereo, EachEyeStaysInItsHalf) {
  Order order;
  order.stereo = true;
  for (const char* scene : scene_names) {
    const Outcome run = outcome_of(assemble_jones(scene, true), order);
    ASSERT_EQ(run.views.size(), 2U);
    int halves[2] = {0, 0};
    for (const ScreenSegment& piece : pieces_of(run.views[1])) {
      EXPECT_EQ(piece.a.x < 512, piece.b.x < 512) << scene;
      ++halves[piece.a.x < 512 ? 0 : 1];
    }
    EXPECT_GT(halves[0], 2) << scene;
    EXPECT_GT(halves[1], 2) << scene;
  }
}

// Ten units between the eyes: 51 half points at a distance of 100, a third of a half point at 16000.
TEST(JonesGuestStereo, FarPointsAreEqualInBothHalves) {
  const scene::CellScene scene =
      one_cell({2000, 200, 0}, {{0, 0, -100}, {4000, 400, 16000}},
               {{{2020, 210, 100}, {2020, 240, 100}}, {{3000, 0, 16000}, {3000, 400, 16000}}});
  Order order;
  order.stereo = true;
  const Outcome run = outcome_of(assemble_jones(scene, true), order);
  ASSERT_EQ(run.views.size(), 2U);
  std::vector<ScreenSegment> left, right;
  for (const ScreenSegment& piece : pieces_of(run.views[1]))
    (piece.a.x < 512 ? left : right).push_back(piece);
  ASSERT_EQ(left.size(), 2U);
  ASSERT_EQ(right.size(), 2U);
  const auto apart = [&](std::size_t i) { return left[i].a.x - (right[i].a.x - 512); };
  const std::size_t far = std::abs(apart(0)) < std::abs(apart(1)) ? 0 : 1;
  EXPECT_EQ(apart(far), 0);
  EXPECT_EQ(left[far].a.y, right[far].a.y);
  EXPECT_NEAR(apart(1 - far), 25.6, 1.0) << "seen from the left, a near thing is farther right";
}

}  // namespace
}  // namespace sightline::programs::jones
