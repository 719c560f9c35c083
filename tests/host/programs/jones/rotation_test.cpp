// The view of Jones's program turned about the vertical (-D ROTATE=1): on the machine and in its twin, word for word; the steps of a
// turned walk compared with floating point; turns by right angles compared with the picture of the same scene turned.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "host/programs/jones/jones.hpp"
#include "host/programs/jones/twin/rotation.hpp"
#include "tests/firmware/jones_core.hpp"
#include "tests/firmware/jones_scenes.hpp"
#include "tests/support/dice.hpp"
#include "tests/support/effort.hpp"
#include "tools/asm/pdp7.hpp"

namespace sightline::programs::jones {
namespace {

const int random_views = tests::effort(150, 4);
const int random_moves = tests::effort(20, 2);

constexpr Build with_rotation(bool eae) { return {.eae = eae, .walk = true, .rotation = true}; }

std::string text_of(const geometry::Point& p) { return std::to_string(p[0]) + ',' + std::to_string(p[1]) + ',' + std::to_string(p[2]); }

geometry::Point eye_in(const scene::Cell& cell, Dice& dice) {
  geometry::Point eye{};
  for (std::size_t a = 0; a < 3; ++a) eye[a] = dice(cell.box.low[a] + 1, cell.box.high[a] - 1);
  return eye;
}

class JonesRotation : public testing::TestWithParam<std::tuple<std::string, bool>> {
 protected:
  [[nodiscard]] bool eae() const { return std::get<1>(GetParam()); }
  scene::CellScene scene_ = scene::builtin_scene(std::get<0>(GetParam()));
};

TEST_P(JonesRotation, IsItsTwinWordForWord) {
  const auto program = Prepared::of(scene_, with_rotation(eae()));
  ASSERT_TRUE(program) << program.error().message();
  Dice dice(1971);
  std::size_t segments = 0;
  for (int n = 0; n < random_views; ++n) {
    Order order;
    order.eye = eye_in(scene_.cells[static_cast<std::size_t>(dice(0, static_cast<std::int32_t>(scene_.cells.size()) - 1))], dice);
    order.angle = dice(0, 3) == 0 ? 90 * dice(-4, 4) : dice(-400, 400);
    if (dice(0, 3) == 0) order.scale = dice(0, 3) == 0 ? (dice(0, 1) == 0 ? 64 : 4096) : dice(64, 4096);
    order.stereo = dice(0, 9) == 0;
    order.immediate = dice(0, 9) == 0;
    order.display = false;
    order.views = 1;
    order.check = true;
    const auto outcome = program->run(order);
    ASSERT_TRUE(outcome) << outcome.error().message() << " from " << text_of(*order.eye) << " at " << order.angle << " scale " << order.scale.value_or(512);
    EXPECT_EQ(outcome->view().status, Status::complete);
    segments += outcome->view().pieces;
  }
  EXPECT_GT(segments, static_cast<std::size_t>(3 * random_views));
}

TEST_P(JonesRotation, WalksWhereItLooks) {
  const auto program = Prepared::of(scene_, with_rotation(eae()));
  ASSERT_TRUE(program) << program.error().message();
  Dice dice(7);
  for (int walk = 0; walk < random_moves; ++walk) {
    Order order;
    order.check = true;
    order.angle = dice(-180, 180);
    for (int n = 0; n < 8; ++n) order.walk.push_back({{dice(-40, 40), dice(-40, 40), dice(-40, 40)}, dice(-360, 360)});
    const auto outcome = program->run(order);
    ASSERT_TRUE(outcome) << outcome.error().message();
    // Where no wall and no plane is in the way the eye is within a unit of the place that the sum of all moves has.
    double x = scene_.default_view[0], z = scene_.default_view[2];
    std::int32_t angle = order.angle;
    for (std::size_t n = 0; n < outcome->views.size(); ++n) {
      const View& view = outcome->views[n];
      const Move move = n == 0 ? Move{} : order.walk[n - 1];
      angle += move.turn;
      EXPECT_EQ((angle - view.angle) % 360, 0);
      const double radians = angle * std::numbers::pi / 180;
      x += move.steps[0] * std::cos(radians) + move.steps[2] * std::sin(radians);
      z += move.steps[2] * std::cos(radians) - move.steps[0] * std::sin(radians);
      if (view.stops != 0) break;
      const scene::Cell& cell = scene_.cells[view.cell];
      if (view.eye[0] - cell.box.low[0] < 3 || cell.box.high[0] - view.eye[0] < 3 || view.eye[2] - cell.box.low[2] < 3 || cell.box.high[2] - view.eye[2] < 3) break;
      EXPECT_NEAR(view.eye[0], x, 0.51) << n;
      EXPECT_NEAR(view.eye[2], z, 0.51) << n;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, JonesRotation, testing::Combine(testing::Values("house", "roberts", "corridor8"), testing::Bool()),
                         [](const auto& p) { return std::get<0>(p.param) + (std::get<1>(p.param) ? "_WithEae" : "_WithoutEae"); });

// All builds of the arithmetic.
TEST(JonesRotationBuilds, AreTheirTwins) {
  const scene::CellScene house = scene::builtin_scene("house");
  Dice dice(3);
  for (const bool eae : {true, false}) {
    for (std::uint32_t fraction = 0; fraction <= 3; ++fraction) {
      for (const bool truncate : {false, true}) {
        Build build = with_rotation(eae);
        build.fraction_bits = fraction;
        build.truncate = truncate;
        const auto program = Prepared::of(house, build);
        ASSERT_TRUE(program) << program.error().message();
        for (int n = 0; n < tests::effort(20, 1); ++n) {
          Order order;
          order.eye = eye_in(house.cells[static_cast<std::size_t>(dice(0, 2))], dice);
          order.angle = dice(0, 359);
          order.scale = dice(64, 4096);
          order.display = false;
          order.views = 1;
          order.check = true;
          const auto outcome = program->run(order);
          ASSERT_TRUE(outcome) << outcome.error().message() << " fraction " << fraction << " from " << text_of(*order.eye) << " at " << order.angle;
        }
      }
    }
  }
}

// Openings all around, above and below, and the eye exactly under an edge of one.
TEST(JonesRotationScenes, RoomsAboveAndBelowTheEye) {
  scene::CellScene scene = one_cell({100, 100, 100}, {{0, 0, 0}, {200, 200, 200}}, {{{50, 0, 20}, {50, 0, 180}}, {{20, 0, 50}, {180, 0, 50}}});
  scene.cells.push_back({{{0, 200, 0}, {200, 400, 200}}, {{{60, 400, 60}, {140, 400, 60}}, {{70, 200, 70}, {70, 400, 70}}}});
  scene::Opening hatch;
  hatch.cells = {0, 1};
  hatch.ring = {{60, 200, 60}};
  hatch.vectors = {{true, 0, 80}, {true, 2, 80}, {true, 0, -80}, {true, 2, -80}};
  hatch.place = {1, 200};
  scene.openings.push_back(hatch);
  for (const bool eae : {true, false}) {
    const auto program = Prepared::of(scene, with_rotation(eae));
    ASSERT_TRUE(program) << program.error().message();
    for (const geometry::Point eye : {geometry::Point{100, 100, 100}, {60, 100, 100}, {140, 150, 60}, {60, 60, 60}, {140, 199, 140}, {61, 199, 61}, {30, 30, 30}, {100, 1, 140}}) {
      for (std::int32_t angle = 0; angle < 360; angle += tests::is_optimised() ? 3 : 45) {
        for (const std::int32_t scale : {64, 128, 512}) {
          Order order;
          order.eye = eye;
          order.angle = angle;
          order.scale = scale;
          order.display = false;
          order.views = 1;
          order.check = true;
          const auto outcome = program->run(order);
          ASSERT_TRUE(outcome) << outcome.error().message() << " from " << text_of(eye) << " at " << angle << " scale " << scale;
          ASSERT_EQ(outcome->view().status, Status::complete);
        }
      }
    }
  }
}

// Bits changed in the lines of cells, and directions taken from vectors of rings: the same status and words as the twin's. (Of a ring
// that is not closed the machine passes over more than the specification says.)
TEST(JonesRotationScenes, DamagedTapesAsTheTwinReadsThem) {
  NEEDS_OPTIMISED_CODE();
  for (const bool eae : {true, false}) {
    const auto program = Prepared::of(scene::builtin_scene("house"), with_rotation(eae));
    ASSERT_TRUE(program) << program.error().message();
    const Program& whole = program->program();
    std::vector<std::uint32_t> rings, vectors;
    for (const std::uint32_t opening : whole.scene.opening_addresses)
      for (std::uint32_t n = 0; n < whole.core[opening + 5].value(); ++n) rings.push_back(opening + 6 + n);
    for (const std::uint32_t cell : whole.scene.cell_addresses)
      for (std::uint32_t n = 0; n < whole.core[cell + 3].value(); ++n) vectors.push_back(cell + 4 + n);
    Dice dice(5);
    int faults = 0;
    for (int n = 0; n < 300; ++n) {
      std::vector<core::Word18> damaged = whole.core;
      for (int word = 0; word < 2; ++word) {
        core::Word18& at = damaged[vectors[static_cast<std::size_t>(dice(0, static_cast<std::int32_t>(vectors.size()) - 1))]];
        at = core::Word18(at.value() ^ 1U << dice(0, 17));
      }
      core::Word18& of_ring = damaged[rings[static_cast<std::size_t>(dice(0, static_cast<std::int32_t>(rings.size()) - 1))]];
      of_ring = dice(0, 3) == 0 ? of_ring & core::Word18(0477777) : core::Word18(of_ring.value() ^ 0400000U);
      Order order;
      order.angle = dice(0, 359);
      order.display = false;
      order.views = 1;
      order.check = true;
      const auto outcome = run_core(whole, damaged, order);
      ASSERT_TRUE(outcome) << n << ": " << outcome.error().message();
      faults += outcome->view().status == Status::complete ? 0 : 1;
    }
    EXPECT_GT(faults, 10);
  }
}

// A place too far away for the words is a status, and so is a ring with too many corners.
TEST(JonesRotationScenes, Statuses) {
  const scene::CellScene far = one_cell({100, 100, 100}, {{0, 0, 0}, {16000, 200, 20000}}, {{{0, 0, 20000}, {16000, 0, 20000}}});
  const auto program = Prepared::of(far, with_rotation(true));
  ASSERT_TRUE(program) << program.error().message();
  Order order;
  order.display = false;
  order.views = 1;
  order.check = true;
  const auto usual = program->run(order);
  ASSERT_TRUE(usual) << usual.error().message();
  EXPECT_EQ(usual->view().status, Status::complete);
  order.scale = 64;  // K = 16: 16384 units
  const auto wide = program->run(order);
  ASSERT_TRUE(wide) << wide.error().message();
  EXPECT_EQ(wide->view().status, Status::arithmetic_overflow);
}

TEST(JonesRotationDirection, IsTheRoundedSineOfEachDegree) {
  for (int degrees = -720; degrees <= 720; ++degrees) {
    const Direction direction = direction_of(degrees);
    EXPECT_NEAR(direction.sine, 65536 * std::sin(degrees * std::numbers::pi / 180), 0.5001) << degrees;
    EXPECT_NEAR(direction.cosine, 65536 * std::cos(degrees * std::numbers::pi / 180), 0.5001) << degrees;
  }
}

TEST(JonesRotationTape, NeedsTheWalk) {
  std::vector<assembler::SourceFile> sources;
  for (const auto& [file, text] : firmware_tapes()) sources.push_back({std::string(file), std::string(text)});
  sources.push_back({"scene tape", *write_tape(scene::builtin_scene("house"), {}, Tape::view)});
  assembler::Options options;
  options.defines = {{"EAE", 1}, {"ROTATE", 1}};
  const auto assembly = assembler::assemble_pdp7(sources, options);
  EXPECT_FALSE(assembly.ok());
}

// Switches 8 and 9 turn, and `in` then leads where the view looks.
TEST(JonesRotationSwitches, TurnAndWalk) {
  NEEDS_OPTIMISED_CODE();
  const auto at = [](double seconds) { return core::Instant(core::Duration(static_cast<std::int64_t>(seconds * 1e9))); };
  Order order;
  order.views = 60;
  order.switches = {{core::Instant{}, core::Word18(0)}, {at(0.507), core::Word18(0001000)}, {at(1.407), core::Word18(0020000)}};
  const auto outcome = run(scene::builtin_scene("house"), with_rotation(true), order);
  ASSERT_TRUE(outcome) << outcome.error().message();
  EXPECT_EQ(outcome->views.front().angle, 0);
  EXPECT_EQ(outcome->view().angle, 315);
  const View& last = outcome->view();
  EXPECT_LT(last.eye[0], 460);
  EXPECT_NEAR(480 - last.eye[0], last.eye[2] - 20, 1.01);
}

}  // namespace
}  // namespace sightline::programs::jones
