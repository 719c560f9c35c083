// Jones's program at the console: the switches, lines added during a view, an empty picture, and views that cannot be
// completed. Source: SPECIFICATION.md sections 5 and 6.
#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "emulators/core/stroke.hpp"
#include "emulators/machines/pdp7.hpp"
#include "host/programs/jones/jones.hpp"
#include "tests/firmware/jones_core.hpp"
#include "tests/firmware/jones_drawn_points.hpp"
#include "tests/firmware/jones_scenes.hpp"
#include "tests/support/effort.hpp"

namespace sightline::programs::jones {
namespace {

constexpr std::uint32_t left = 0400000, right = 0200000, up = 0100000, down = 040000, in = 020000,
                        out = 010000, bigger = 04000, smaller = 02000;

core::Instant at(double seconds) {
  return core::Instant(core::Duration(static_cast<std::int64_t>(seconds * 1e9)));
}

struct Console {
  SpacePoint eye;
  std::int32_t scale = 0;
  std::int32_t views = 0;
};

class JonesSwitches : public testing::Test {
 protected:
  // Sets the switches from just after half a second for `held` seconds; afterwards the program applies the accumulated motion.
  Console after(std::uint32_t switches, double held) {
    pdp7::Machine machine;
    EXPECT_EQ(machine.attach("display"), "");
    machine.load(0, program.core);
    machine.console().schedule({{at(0.507), core::Word18(switches)}, {at(0.507 + held), core::Word18(0)}});
    machine.start(program.labels.start);
    pdp7::Limits limits;
    limits.until = at(0.507 + held + 1.0);
    EXPECT_EQ(machine.run(limits), pdp7::StopReason::time_limit);
    const auto cell = [&](const char* name) { return machine.peek(tag(program, name)).twos_complement(); };
    return {{cell("ex"), cell("ey"), cell("ez")}, cell("scale"), cell("views")};
  }
  void SetUp() override {
    const geometry::Box& box = program.scene.view.limits;
    home = {(box.low[0] + box.high[0]) / 2, (box.low[1] + box.high[1]) / 2, (box.low[2] + box.high[2]) / 2};
    put_eye(program, home);
  }
  Program program = assemble_jones("corridor8", true);
  SpacePoint home;
};

TEST_F(JonesSwitches, FiftyStepsASecondBetweenViews) {
  const Console still = after(0, 1.0);
  EXPECT_EQ(still.eye, home);
  EXPECT_EQ(still.scale, 512);
  EXPECT_GT(still.views, 5);
  EXPECT_EQ(after(left, 1.0).eye, (SpacePoint{home.x - 50, home.y, home.z}));
  EXPECT_EQ(after(right, 1.0).eye, (SpacePoint{home.x + 50, home.y, home.z}));
  EXPECT_EQ(after(up, 1.0).eye, (SpacePoint{home.x, home.y + 50, home.z}));
  EXPECT_EQ(after(down, 1.0).eye, (SpacePoint{home.x, home.y - 50, home.z}));
  EXPECT_EQ(after(in, 1.0).eye, (SpacePoint{home.x, home.y, home.z + 50}));
  EXPECT_EQ(after(out, 1.0).eye, (SpacePoint{home.x, home.y, home.z - 50}));
  EXPECT_EQ(after(bigger, 1.0).scale, 512 + 50 * 8);
  EXPECT_EQ(after(smaller, 1.0).scale, 512 - 50 * 8);
  const Console three = after(right | up | out | bigger, 0.2);
  EXPECT_EQ(three.eye, (SpacePoint{home.x + 10, home.y + 10, home.z - 10}));
  EXPECT_EQ(three.scale, 512 + 10 * 8);
}

TEST_F(JonesSwitches, OppositesCancel) {
  const Console all = after(left | right | up | down | in | out | bigger | smaller, 1.0);
  EXPECT_EQ(all.eye, home);
  EXPECT_EQ(all.scale, 512);
}

TEST_F(JonesSwitches, ScaleStaysInItsRange) {
  NEEDS_OPTIMISED_CODE();
  EXPECT_EQ(after(bigger, 10.0).scale, 4096);
  EXPECT_EQ(after(smaller, 2.0).scale, 64);
}

TEST_F(JonesSwitches, TheEyeStaysInItsBox) {
  NEEDS_OPTIMISED_CODE();
  const geometry::Box& box = program.scene.view.limits;
  EXPECT_EQ(after(left, 5.0).eye.x, box.low[0]);
  EXPECT_EQ(after(right, 5.0).eye.x, box.high[0]);
  EXPECT_EQ(after(down, 5.0).eye.y, box.low[1]);
  EXPECT_EQ(after(up, 5.0).eye.y, box.high[1]);
  EXPECT_EQ(after(out, 5.0).eye.z, box.low[2]);
}

// Close to the far wall nothing may be visible; the program must continue all the same.
TEST_F(JonesSwitches, AnEmptyPictureIsShown) {
  program = assemble_jones(one_cell({200, 200, 50}, {{0, 0, 0}, {400, 400, 400}}, {}), true);
  ASSERT_EQ(twin_view(program).display_file.size(), 2U);
  const Console seen = after(0, 1.0);
  EXPECT_GT(seen.views, 10);
  Order order;
  order.time_limit = core::seconds(5);
  const Outcome run = outcome_of(program, order);
  EXPECT_EQ(run.views.size(), 2U);
  EXPECT_TRUE(run.pass.empty());
}

// Checks the displayed file after every store into one of the two files.
class FileWatch final : public pdp7::Observer {
 public:
  explicit FileWatch(const Program& program)
      : program_(program),
        shadow_(image_of(program)),
        file_(program.labels.file),
        running_(tag(program, "runing")) {}

  void cycle(const pdp7::Cycle& cycle) override {
    if (cycle.verb != pdp7::Verb::write && cycle.verb != pdp7::Verb::modify) return;
    shadow_.at(cycle.address) = cycle.data;
    if (cycle.address == program_.labels.views) stop_ = true;
    const pdp7::Address first = tag(program_, "filea");
    if (cycle.address < first || shadow_.at(running_).value() == 0) return;
    ++stores_;
    if (!terminated()) ++runaways_;
  }
  bool stop(core::Instant, pdp7::Address) override { return std::exchange(stop_, false); }
  [[nodiscard]] int stores() const { return stores_; }
  [[nodiscard]] int runaways() const { return runaways_; }

 private:
  [[nodiscard]] bool terminated() const {
    std::uint32_t mode = 0;
    for (std::uint32_t n = 0, from = shadow_.at(file_).value(); n < program_.labels.file_words; ++n) {
      const core::Word18 word = shadow_.at(from + n);
      if (mode == 0 && word.bit(7)) return true;
      if (mode != 4) {
        mode = word.field(2, 4);
      } else if (word.bit(0)) {
        mode = 0;
      }
      if (mode != 0 && mode != 1 && mode != 4) return false;
    }
    return false;
  }

  const Program& program_;
  std::vector<core::Word18> shadow_;
  pdp7::Address file_;
  pdp7::Address running_;
  bool stop_ = false;
  int stores_ = 0;
  int runaways_ = 0;
};

// Counts the flashes of each pass.
struct PassSizes final : core::StrokeTaker {
  void begin_pass(core::Instant) override { sizes.push_back(0); }
  void strokes(std::span<const core::Stroke> strokes) override {
    if (!sizes.empty()) sizes.back() += static_cast<int>(strokes.size());
  }
  std::vector<int> sizes;
};

TEST(JonesImmediate, LinesAppearDuringTheViewInAFileThatIsAlwaysTerminated) {
  for (const bool eae : {true, false}) {
    const Program program = assemble_jones("roberts", eae);
    FileWatch watch(program);
    PassSizes screen;
    pdp7::Options options;
    options.model.eae = eae;
    pdp7::Machine machine(options);
    ASSERT_EQ(machine.attach("display"), "");
    machine.strokes().hand_to(&screen);
    machine.load(0, program.core);
    machine.console().set(core::Word18(2));
    machine.start(program.labels.start);
    pdp7::Limits limits;
    limits.until = at(60);
    for (int stop = 0; stop < 3; ++stop) {  // the first stores a count of zero
      screen.sizes.clear();
      ASSERT_EQ(machine.run(limits, watch), pdp7::StopReason::observer);
    }
    EXPECT_GT(watch.stores(), 300);
    EXPECT_EQ(watch.runaways(), 0);
    // View 2 shows the previous picture until there is a line, then more and more lines.
    ASSERT_GT(screen.sizes.size(), 5U);
    screen.sizes.pop_back();  // incomplete when the view ended
    const auto shortest = std::min_element(screen.sizes.begin() + 1, screen.sizes.end());
    EXPECT_TRUE(std::is_sorted(shortest, screen.sizes.end()));
    EXPECT_LT(2 * *shortest, screen.sizes.back());
    const auto end = std::unique(screen.sizes.begin(), screen.sizes.end());
    EXPECT_GT(end - screen.sizes.begin(), 4);
  }
}

// A view that cannot be completed: its status, the displayed part, and the next view.
class JonesStatus : public testing::TestWithParam<bool> {
 protected:
  void expect(Program program, Status status, std::size_t least_pieces) const {
    const TwinView expected = twin_view(program);
    ASSERT_EQ(name(expected.status), name(status));
    Order order;
    order.time_limit = core::seconds(60);
    const Outcome run = outcome_of(program, order);
    ASSERT_EQ(run.views.size(), 2U);
    for (const View& view : run.views) {
      EXPECT_EQ(name(view.status), name(status));
      EXPECT_TRUE(same_words(view.display_file, expected.display_file));
      EXPECT_GE(view.pieces, least_pieces);
    }
    EXPECT_EQ(points_of(run.pass), drawn_points(expected.display_file));
  }
  static Program with(const scene::CellScene& scene) { return assemble_jones(scene, GetParam()); }
};

TEST_P(JonesStatus, StackOverflow) {
  scene::CellScene scene = grazing_doorways_scene(51);
  scene.cells[0].lines = {{{150, 150, 100}, {250, 150, 100}}};
  expect(with(scene), Status::stack_overflow, 1);
  scene = grazing_doorways_scene(50);
  scene.cells[0].lines = {{{150, 150, 100}, {250, 150, 100}}};
  expect(with(scene), Status::complete, 1);
}

TEST_P(JonesStatus, DisplayFileOverflow) {
  expect(with(many_lines(345)), Status::complete, 345);
  expect(with(many_lines(360)), Status::display_file_overflow, 345);
}

TEST_P(JonesStatus, TooManyMaskVertices) {
  expect(with(stairs(7)), Status::complete, 16);
  expect(with(stairs(8)), Status::too_many_mask_vertices, 15);
}

TEST_P(JonesStatus, DeeperThanTheNumberOfCells) {
  Program program = with(scene::builtin_scene("house"));
  program.core[program.labels.scene + 1] = core::Word18(1);
  expect(program, Status::deeper_than_cells, 1);
}

TEST_P(JonesStatus, BadDataElement) {
  Program program = with(scene::builtin_scene("house"));
  // Damages the last vector of the initial cell: the lines before it are drawn.
  const pdp7::Address count = program.scene.cell_addresses.at(program.scene.view.cell) + 3;
  constexpr std::uint32_t without_axis = 0477777;
  core::Word18& last = program.core[count + program.core[count].value()];
  last = last & core::Word18(without_axis);
  expect(program, Status::bad_data_element, 1);
}

INSTANTIATE_TEST_SUITE_P(Eae, JonesStatus, testing::Bool(),
                         [](const auto& eae) { return std::string(eae.param ? "WithEae" : "WithoutEae"); });

}  // namespace
}  // namespace sightline::programs::jones
