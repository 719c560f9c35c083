// Jones's program on the emulated PDP-7 compared with its native twin on random views of every scene: the same display words and
// the same
// status, bit for bit, with and without the EAE, in every mode.
//
// Most views are computed without a display on the machine; some run as a user would see them, the second view while the first is
// refreshed. The worst time of a view is recorded without a limit.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <tuple>

#include "host/programs/jones/jones.hpp"
#include "tests/firmware/jones_path_watch.hpp"
#include "tests/support/dice.hpp"
#include "tests/support/effort.hpp"

namespace sightline::programs::jones {
namespace {

const int views = tests::effort(1000, 10);
constexpr int one_with_display_in = 25;
constexpr std::int32_t room_before_far_side = 8;

// Strictly inside the initial cell, and not close to its far side.
SpacePoint random_eye(const geometry::Box& limits, Dice& dice) {
  return {dice(limits.low[0], limits.high[0]), dice(limits.low[1], limits.high[1]),
          dice(limits.low[2], limits.high[2] + near_z - room_before_far_side)};
}

Parameters random_parameters(Dice& dice) {
  Parameters parameters;
  if (dice(0, 3) == 0) parameters.scale = dice(0, 3) == 0 ? (dice(0, 1) ? 64 : 4096) : dice(64, 4096);
  parameters.stereo = dice(0, 9) == 0;
  parameters.immediate = dice(0, 9) == 0;
  return parameters;
}

std::string described(const Parameters& p) {
  return "eye " + std::to_string(p.eye.x) + ',' + std::to_string(p.eye.y) + ',' + std::to_string(p.eye.z) +
         " scale " + std::to_string(p.scale) + (p.stereo ? " stereo" : "") +
         (p.immediate ? " immediate" : "");
}

class JonesRandomViews : public testing::TestWithParam<std::tuple<std::string, bool>> {
 protected:
  std::string scene() const { return std::get<0>(GetParam()); }
  bool eae() const { return std::get<1>(GetParam()); }

  // The same view while the display shows the previous picture.
  void expect_same_with_display(const Program& program, const Parameters& parameters,
                                const TwinView& expected) const {
    Order order;
    order.scale = parameters.scale;
    order.stereo = parameters.stereo;
    order.immediate = parameters.immediate;
    order.time_limit = core::seconds(60);
    const Outcome run = outcome_of(program, order);
    ASSERT_EQ(run.views.size(), 2U) << expected.display_file.size() << " display words";
    for (const View& view : run.views) {
      EXPECT_EQ(name(view.status), name(expected.status));
      EXPECT_TRUE(same_words(view.display_file, expected.display_file));
      EXPECT_EQ(view.visits, expected.counts.visits);
      EXPECT_EQ(view.distinct_cells, expected.counts.distinct_cells);
      EXPECT_EQ(view.pieces, expected.counts.pieces);
    }
    // If lines are added at once the first view is displayed while it is made, too; an empty picture is not refreshed.
    if (!parameters.immediate && run.views[0].pieces > 0) {
      EXPECT_GT(run.views[1].time, run.views[0].time) << "the display steals cycles";
    }
  }
};

TEST_P(JonesRandomViews, GuestAndTwinAgree) {
  Program program = assemble_jones(scene(), eae());
  const std::size_t cells = program.scene.cell_addresses.size();
  // The same views with the EAE and without.
  Dice dice(1971);
  core::Duration sum{}, worst{};
  std::string worst_view;
  std::size_t deepest = 0, longest_file = 0;
  std::uint64_t most_visits = 0;
  for (int i = 0; i < views; ++i) {
    Parameters parameters = random_parameters(dice);
    parameters.eye = random_eye(program.scene.view.limits, dice);
    put_eye(program, parameters.eye);
    SCOPED_TRACE(scene() + (eae() ? " with EAE " : " without EAE ") + described(parameters));
    const TwinView expected = twin_view(program, parameters);
    const DarkView view = dark_view(program, eae(), parameters);
    ASSERT_EQ(name(view.status), name(expected.status));
    ASSERT_TRUE(same_words(view.display_file, expected.display_file));
    EXPECT_EQ(view.status, Status::complete);
    EXPECT_EQ(view.visits, expected.counts.visits);
    EXPECT_EQ(view.depth, static_cast<std::size_t>(expected.counts.depth));
    EXPECT_LE(view.depth, cells);
    EXPECT_FALSE(view.reentered);
    if (i % one_with_display_in == 0) expect_same_with_display(program, parameters, expected);
    sum += view.time;
    deepest = std::max(deepest, view.depth);
    most_visits = std::max(most_visits, view.visits);
    longest_file = std::max(longest_file, view.display_file.size());
    if (view.time > worst) {
      worst = view.time;
      worst_view = described(parameters);
    }
  }
  const auto seconds = [](core::Duration time) { return core::in_seconds(time); };
  std::printf(
      "%-10s %-11s %d views: mean %.3f s, worst %.3f s (%s); depth %zu of %zu cells, visits %llu, words "
      "%zu\n",
      scene().c_str(), eae() ? "with EAE" : "without EAE", views, seconds(sum) / views, seconds(worst),
      worst_view.c_str(), deepest, cells, static_cast<unsigned long long>(most_visits), longest_file);
}

INSTANTIATE_TEST_SUITE_P(
    BuiltIn, JonesRandomViews,
    testing::Combine(testing::ValuesIn(std::vector<std::string>(scene_names.begin(), scene_names.end())),
                     testing::Bool()),
    [](const auto& p) { return std::get<0>(p.param) + (std::get<1>(p.param) ? "_WithEae" : "_WithoutEae"); });

}  // namespace
}  // namespace sightline::programs::jones
