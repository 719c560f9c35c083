// The walk of Jones's program (-D WALK=1): each eye and cell on the machine compared with its twin and with an oracle that
// moves through the solids and walls of the scene and knows nothing of its openings; views on the way compared with the twin
// and with those of the program without the walk from the same eye, word for word.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "emulators/machines/pdp7.hpp"
#include "emulators/pdp7/timing.hpp"
#include "host/programs/jones/jones.hpp"
#include "host/programs/jones/twin/walk.hpp"
#include "tests/firmware/jones_core.hpp"
#include "tests/support/dice.hpp"
#include "tests/support/effort.hpp"
#include "tools/asm/pdp7.hpp"

namespace sightline::programs::jones {
namespace {

using geometry::Box;
using geometry::Point;

const int random_steps = tests::effort(10000, 200);
const int random_views = tests::effort(60, 3);

std::string text_of(const Point& p) { return std::to_string(p[0]) + ',' + std::to_string(p[1]) + ',' + std::to_string(p[2]); }

// Where SPECIFICATION.md section 9 puts an eye, from the matter of a scene and the boxes of its cells.
class FreeSpace {
 public:
  explicit FreeSpace(const scene::CellScene& scene) : scene_(scene) {}

  struct Stay {
    Point eye;
    std::size_t cell = 0;
    std::uint32_t stops = 0;
  };
  // The cells that have the point strictly inside.
  [[nodiscard]] std::vector<std::size_t> cells_around(const Point& eye) const {
    std::vector<std::size_t> cells;
    for (std::size_t c = 0; c < scene_.cells.size(); ++c)
      if (scene_.cells[c].box.contains_inside(eye)) cells.push_back(c);
    return cells;
  }
  [[nodiscard]] Stay after(Stay stay, const Steps& steps) const {
    stay.stops = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (steps[axis] != 0) take_leg(stay, axis, steps[axis]);
    return stay;
  }

 private:
  // Whether a box with the low faces, without the high ones, has the point on the axes other than `axis`.
  static bool across(const Box& box, const Point& p, std::size_t axis) {
    for (std::size_t a = 0; a < 3; ++a)
      if (a != axis && (p[a] < box.low[a] || p[a] >= box.high[a])) return false;
    return true;
  }
  // Whether what lies behind this plane, or in it, is opaque there: the unit of space from `plane` on in the direction.
  [[nodiscard]] bool opaque(std::size_t axis, std::int32_t plane, std::int32_t sign, const Point& p) const {
    const auto holds = [&](const Box& box) {
      const std::int32_t low = sign > 0 ? plane : plane - 1;
      return across(box, p, axis) && box.low[axis] <= low && low < box.high[axis];
    };
    if (!holds(scene_.outer)) return true;
    for (const Box& solid : scene_.solids)
      if (holds(solid)) return true;
    for (const geometry::Rectangle& wall : scene_.walls) {
      if (wall.axis != axis || wall.at != plane) continue;
      const auto axes = geometry::other_axes(axis);
      if (wall.sides[0].low <= p[axes[0]] && p[axes[0]] < wall.sides[0].high && wall.sides[1].low <= p[axes[1]] && p[axes[1]] < wall.sides[1].high) return true;
    }
    return false;
  }
  void take_leg(Stay& stay, std::size_t axis, std::int32_t steps) const {
    const std::int32_t sign = steps < 0 ? -1 : 1;
    Point& eye = stay.eye;
    for (std::int32_t left = steps * sign; left > 0; --left) {
      if (opaque(axis, eye[axis] + sign, sign, eye)) {
        stay.stops |= 1U << axis;
        break;
      }
      eye[axis] += sign;
    }
    for (std::size_t c = 0; c < scene_.cells.size(); ++c) {
      const Box& box = scene_.cells[c].box;
      const bool along = sign > 0 ? box.low[axis] <= eye[axis] && eye[axis] < box.high[axis] : box.low[axis] < eye[axis] && eye[axis] <= box.high[axis];
      if (!along || !across(box, eye, axis)) continue;
      stay.cell = c;
      for (std::size_t a = 0; a < 3; ++a) eye[a] = std::clamp(eye[a], box.low[a] + 1, box.high[a] - 1);
      return;
    }
    ADD_FAILURE() << "no cell has " << text_of(eye);
  }

  const scene::CellScene& scene_;
};

// Calls the routine that begins a view, without the view.
class WalkMachine {
 public:
  explicit WalkMachine(Program program) : program_(std::move(program)), machine_(options(program_)) {
    machine_.load(0, program_.core);
    const pdp7::Address call = tag(program_, "filea");
    for (const auto& [routine, at] : {std::pair{"initpr", call}, std::pair{"travel", static_cast<pdp7::Address>(call + 2)}}) {
      machine_.deposit(at, core::Word18(0100000U | tag(program_, routine)));  // JMS
      machine_.deposit(at + 1, core::Word18(0740040));                        // HLT
    }
    machine_.deposit(tag(program_, "fault"), core::Word18(0740040));
    run_from(call);
  }

  // The status.
  Status take(const Steps& steps) {
    for (std::size_t a = 0; a < 3; ++a) set(program_.labels.steps + static_cast<pdp7::Address>(a), steps[a]);
    const pdp7::Address halted = run_from(tag(program_, "filea") + 2);
    return halted == tag(program_, "fault") ? static_cast<Status>(machine_.registers().ac.value()) : Status::complete;
  }
  void set(pdp7::Address address, std::int32_t value) { machine_.deposit(address, word_of(value)); }
  [[nodiscard]] core::Word18 word(pdp7::Address address) const { return machine_.peek(address); }
  [[nodiscard]] Point eye() const {
    Point eye{};
    for (std::size_t a = 0; a < 3; ++a) eye[a] = word(program_.labels.eye + static_cast<pdp7::Address>(a)).twos_complement();
    return eye;
  }
  void put_eye(const Point& eye) {
    for (std::size_t a = 0; a < 3; ++a) set(program_.labels.eye + static_cast<pdp7::Address>(a), eye[a]);
  }
  [[nodiscard]] std::uint32_t cell() const { return word(program_.labels.scene).value(); }
  [[nodiscard]] std::uint32_t stops() const { return word(program_.labels.stops).value(); }
  [[nodiscard]] const Program& program() const { return program_; }

 private:
  static pdp7::Options options(const Program& program) {
    pdp7::Options options;
    options.model.eae = program.build.eae;
    return options;
  }
  pdp7::Address run_from(pdp7::Address address) {
    machine_.registers().pc = address;
    pdp7::Limits limits;
    limits.instructions = 1'000'000;
    EXPECT_EQ(machine_.run(limits), pdp7::StopReason::halt);
    return static_cast<pdp7::Address>(machine_.registers().pc - 1);
  }

  Program program_;
  pdp7::Machine machine_;
};

Program assembled(const scene::CellScene& scene, bool eae) {
  auto program = assemble_program(scene, {.eae = eae, .walk = true});
  if (!program) {
    ADD_FAILURE() << program.error().message();
    return {};
  }
  return std::move(*program);
}

Walk twin_of(const Program& program) { return {program.core, program.labels.scene, program.scene.cell_addresses.front()}; }

Steps random_step(Dice& dice) {
  Steps steps{};
  const std::int32_t most = dice(0, 9) == 0 ? most_steps : dice(0, 2) == 0 ? 3 : 120;
  for (std::int32_t& step : steps)
    if (dice(0, 2) != 0) step = dice(-most, most);
  return steps;
}

class JonesWalk : public testing::TestWithParam<std::tuple<std::string, bool>> {
 protected:
  [[nodiscard]] std::string name() const { return std::get<0>(GetParam()); }
  [[nodiscard]] bool eae() const { return std::get<1>(GetParam()); }
  scene::CellScene scene_ = scene::builtin_scene(name());
};

TEST_P(JonesWalk, IsNeverInAWrongCell) {
  WalkMachine machine(assembled(scene_, eae()));
  Walk twin = twin_of(machine.program());
  const FreeSpace space(scene_);
  FreeSpace::Stay stay{scene_.default_view};
  const auto& cells = machine.program().scene.cell_addresses;
  std::vector<bool> entered(cells.size());
  Dice dice(1971);
  int walls = 0;
  for (int n = 0; n < random_steps; ++n) {
    const Steps steps = n == 0 ? Steps{} : random_step(dice);
    SCOPED_TRACE("step " + std::to_string(n) + " from " + text_of(stay.eye) + " by " + text_of(steps));
    stay = space.after(stay, steps);
    ASSERT_EQ(machine.take(steps), Status::complete);
    ASSERT_EQ(twin.take(steps), Status::complete);
    ASSERT_EQ(text_of(machine.eye()), text_of(stay.eye));
    ASSERT_EQ(twin.eye(), stay.eye);
    ASSERT_EQ(machine.stops(), stay.stops);
    ASSERT_EQ(twin.stops(), stay.stops);
    const auto around = space.cells_around(stay.eye);
    ASSERT_EQ(around.size(), 1U);
    ASSERT_EQ(machine.cell(), cells[around[0]]);
    for (pdp7::Address word = 0; word < scene_header_words; ++word) {
      if (word >= 2 && word < 5) continue;  // the first eye
      const pdp7::Address at = machine.program().labels.scene + word;
      ASSERT_EQ(machine.word(at), twin.core()[at]);
    }
    entered[around[0]] = true;
    walls += stay.stops != 0 ? 1 : 0;
  }
  EXPECT_GT(walls, random_steps / 20);
  if (tests::is_optimised()) {
    EXPECT_GT(std::count(entered.begin(), entered.end(), true), name() == "corridor32" ? 4 : static_cast<int>(cells.size()) * 2 / 3);
  }
}

TEST_P(JonesWalk, DrawsWhatTheProgramWithoutItDraws) {
  const auto walking = Prepared::of(scene_, {.eae = eae(), .walk = true});
  const auto standing = Prepared::of(scene_, {.eae = eae()});
  ASSERT_TRUE(walking && standing);
  Dice dice(7);
  Order order;
  order.check = true;
  for (int n = 0; n < random_views; ++n) order.walk.push_back({random_step(dice)});
  const auto outcome = walking->run(order);
  ASSERT_TRUE(outcome) << outcome.error().message();
  ASSERT_EQ(outcome->views.size(), order.walk.size() + 1);
  core::Duration walked{}, stood{}, most_added{};
  double worst = 0;
  for (const View& view : outcome->views) {
    Order still;
    still.eye = view.eye;
    const auto there = standing->run(still);
    ASSERT_TRUE(there) << there.error().message();
    ASSERT_TRUE(same_words(view.display_file, there->view().display_file)) << text_of(view.eye);
    ASSERT_EQ(view.status, there->view().status);
    EXPECT_EQ(view.visits, there->view().visits);
    EXPECT_EQ(view.distinct_cells, there->view().distinct_cells);
    if (&view == &outcome->views.front()) continue;  // no display yet
    // A view of almost nothing, close to a wall, takes a few milliseconds, and so does a walk through the whole scene: single views
    // may take longer.
    most_added = std::max(most_added, view.time - there->view().time);
    worst = std::max(worst, core::in_seconds(view.time) / core::in_seconds(there->view().time));
    walked += view.time;
    stood += there->view().time;
  }
  EXPECT_LE(walked, stood * 11 / 10);
  std::printf("%-10s %-11s %zu views: %.1f ms walking, %.1f ms standing, at most %.1f ms and %.2f times\n", name().c_str(), eae() ? "with EAE" : "without EAE", outcome->views.size(),
              1000 * core::in_seconds(walked) / static_cast<double>(outcome->views.size()), 1000 * core::in_seconds(stood) / static_cast<double>(outcome->views.size()), 1000 * core::in_seconds(most_added), worst);
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, JonesWalk,
                         testing::Combine(testing::ValuesIn(std::vector<std::string>(scene_names.begin(), scene_names.end())), testing::Bool()),
                         [](const auto& p) { return std::get<0>(p.param) + (std::get<1>(p.param) ? "_WithEae" : "_WithoutEae"); });

class JonesWalkInTheHouse : public testing::Test {
 protected:
  static constexpr std::size_t living = 0, kitchen = 1, dining = 2;

  // The machine after these steps from (480,160,20).
  void expect(const std::vector<Steps>& walk, const Point& eye, std::size_t cell, std::uint32_t stops) {
    machine_.put_eye(house_.default_view);
    machine_.set(machine_.program().labels.scene, 0);
    for (const Steps& steps : walk) ASSERT_EQ(machine_.take(steps), Status::complete);
    EXPECT_EQ(text_of(machine_.eye()), text_of(eye));
    EXPECT_EQ(machine_.cell(), machine_.program().scene.cell_addresses[cell]);
    EXPECT_EQ(machine_.stops(), stops);
  }
  void expect_nowhere(const Point& eye) {
    machine_.put_eye(eye);
    machine_.set(machine_.program().labels.scene, 0);
    EXPECT_EQ(machine_.take({1, 1, 1}), Status::eye_in_no_cell) << text_of(eye);
    EXPECT_EQ(text_of(machine_.eye()), text_of(eye));
    EXPECT_EQ(machine_.cell(), 0U);
  }

  scene::CellScene house_ = scene::builtin_scene("house");
  WalkMachine machine_{assembled(house_, true)};
};

// The house of Fig. 2: doors at x 60 to 150 and 270 to 400, up to y 205, in the wall z = 400; a hatch in x = 250.
TEST_F(JonesWalkInTheHouse, WallsAndDoors) {
  expect({{0, 0, 379}}, {480, 160, 399}, living, 0);
  expect({{0, 0, 380}}, {480, 160, 399}, living, 4);
  expect({{-80, 0, 380}}, {400, 160, 399}, living, 4);          // beside the door: its right side is not in it
  expect({{-81, 0, 380}}, {399, 160, 401}, dining, 0);          // the plane of the door: one unit on
  expect({{-210, 0, 380}}, {270, 160, 401}, dining, 0);         // its left side is in it
  expect({{-211, 0, 380}}, {269, 160, 399}, living, 4);
  expect({{-100, 44, 500}}, {380, 204, 520}, dining, 0);
  expect({{-100, 45, 500}}, {380, 205, 399}, living, 4);        // the lintel
  expect({{-100, 0, 9999}}, {380, 160, 749}, dining, 4);
  expect({{-100, -40, 600}, {-9999, 0, 0}}, {1, 120, 620}, kitchen, 1);  // the hatch
  expect({{-100, -40, 600}, {-129, 0, 0}}, {251, 120, 620}, dining, 0);
  expect({{-100, -40, 600}, {-130, 0, 0}}, {249, 120, 620}, kitchen, 0);
  expect({{-100, -40, 600}, {-200, 0, 0}, {129, 0, 0}}, {309, 120, 620}, dining, 0);
  expect({{-9999, 9999, -9999}}, {1, 249, 1}, living, 7);
  // x first, then y, then z: this way round it meets the wall, not the door.
  expect({{-100, 0, 500}, {200, 0, -500}}, {580, 160, 401}, dining, 4);
}

TEST_F(JonesWalkInTheHouse, NoCell) {
  expect_nowhere({600, 100, 100});    // on a wall
  expect_nowhere({-5, 100, 100});     // outside
  expect_nowhere({100, 100, 400});    // on the plane of a door
  expect_nowhere({250, 120, 620});    // of the hatch
  expect_nowhere({100, 100, 131071});
  EXPECT_TRUE(machine_.take({}) == Status::eye_in_no_cell) << "until an eye is deposited";
  machine_.put_eye({100, 100, 399});
  EXPECT_EQ(machine_.take({}), Status::complete);
}

// A damaged element ends the view with a status; the eye stays where it is.
TEST_F(JonesWalkInTheHouse, BadElements) {
  const Program& program = machine_.program();
  ASSERT_EQ(machine_.take({}), Status::complete);
  const pdp7::Address ring = static_cast<pdp7::Address>(program.scene.opening_addresses[1] + 6);
  const std::int32_t vector = machine_.word(ring).twos_complement();
  machine_.set(ring, 5);
  EXPECT_EQ(machine_.take({-100, 0, 500}), Status::bad_data_element);
  EXPECT_EQ(machine_.cell(), 0U);
  EXPECT_EQ(text_of(machine_.eye()), text_of(Point{380, 160, 20})) << "the finished leg";
  machine_.set(ring, vector);
  EXPECT_EQ(machine_.take({0, 0, 10}), Status::complete);
  EXPECT_EQ(text_of(machine_.eye()), text_of(Point{380, 160, 30}));
  // A tape cut short: no planes.
  machine_.set(program.labels.scene, 0);
  for (const std::uint32_t cell : program.scene.cell_addresses)
    for (std::uint32_t word = cell - 3; word < cell + 4; ++word) machine_.set(static_cast<pdp7::Address>(word), 0);
  EXPECT_EQ(machine_.take({0, 0, 10}), Status::bad_data_element);
  EXPECT_EQ(machine_.cell(), 0U);
}

// Random words in the elements: the same status, eye and cell as the twin's.
TEST_F(JonesWalkInTheHouse, DamagedTapesAsTheTwinReadsThem) {
  NEEDS_OPTIMISED_CODE();
  const Program whole = machine_.program();
  Dice dice(3);
  int faults = 0;
  for (int n = 0; n < 400; ++n) {
    Program damaged = whole;
    const auto first = static_cast<std::int32_t>(whole.labels.scene + scene_header_words);
    const auto last = static_cast<std::int32_t>(whole.labels.scene + whole.scene.words.size() - 1);
    for (int word = 0; word < 2; ++word) {
      core::Word18& at = damaged.core[static_cast<std::size_t>(dice(first, last))];
      at = core::Word18(at.value() ^ 1U << dice(0, 14));
    }
    WalkMachine machine(damaged);
    Walk twin = twin_of(damaged);
    for (int step = 0; step < 20; ++step) {
      const Steps steps = random_step(dice);
      SCOPED_TRACE(std::to_string(n) + ", step " + std::to_string(step) + " by " + text_of(steps));
      const Status expected = twin.take(steps);
      if (expected == Status::unfinished) break;
      ASSERT_EQ(machine.take(steps), expected);
      ASSERT_EQ(text_of(machine.eye()), text_of(twin.eye()));
      ASSERT_EQ(machine.cell(), twin.cell());
      faults += expected != Status::complete ? 1 : 0;
    }
  }
  EXPECT_GT(faults, 50);
}

// The whole program without a cell: the status, and an empty picture.
TEST_F(JonesWalkInTheHouse, APictureOfNothingWithoutACell) {
  Program program = machine_.program();
  put_eye(program, {250, 120, 620});
  Order order;
  order.views = 2;
  const Outcome outcome = outcome_of(program, order);
  ASSERT_EQ(outcome.views.size(), 2U);
  for (const View& view : outcome.views) {
    EXPECT_EQ(view.status, Status::eye_in_no_cell);
    EXPECT_EQ(view.display_file.size(), 2U);
    EXPECT_EQ(view.cell, house_.cells.size());
  }
}

// With the switches of the console the eye goes from the living room to the dining room.
TEST_F(JonesWalkInTheHouse, BySwitches) {
  NEEDS_OPTIMISED_CODE();
  const auto at = [](double seconds) { return core::Instant(core::Duration(static_cast<std::int64_t>(seconds * 1e9))); };
  Order order;
  order.views = 200;
  order.switches = {{core::Instant{}, core::Word18(0)}, {at(0.507), core::Word18(0400000)}, {at(2.507), core::Word18(0020000)}};
  const auto outcome = run(house_, {.walk = true}, order);
  ASSERT_TRUE(outcome) << outcome.error().message();
  EXPECT_EQ(outcome->views.front().cell, living);
  EXPECT_EQ(outcome->view().cell, dining);
  EXPECT_EQ(outcome->view().eye[0], 380);
  EXPECT_GT(outcome->view().eye[2], 401);
  std::int32_t last = 0;
  for (const View& view : outcome->views) {
    EXPECT_EQ(view.stops, 0U);
    EXPECT_GE(view.eye[2], last);
    last = view.eye[2];
  }
}

TEST_F(JonesWalkInTheHouse, StereoPairsKeepTheirEyesInTheCell) {
  const auto walking = Prepared::of(house_, {.walk = true});
  ASSERT_TRUE(walking);
  Order order;
  order.stereo = true;
  order.check = true;
  order.walk = {{{-100, -40, 600}}, {{-128, 0, 0}}, {{-3, 0, 0}}};
  const auto outcome = walking->run(order);
  EXPECT_TRUE(outcome) << outcome.error().message();
}

TEST(JonesWalkTape, HasThePlanesOfTheCells) {
  for (const char* name : scene_names) {
    const scene::CellScene scene = scene::builtin_scene(name);
    const auto walk = encode(scene, {}, 0, Tape::walk);
    const auto view = encode(scene);
    ASSERT_TRUE(walk && view);
    EXPECT_EQ(walk->opening_words, view->opening_words + 5 * scene.openings.size());
    EXPECT_LE(walk->cell_words, view->cell_words + 4 * scene.cells.size());
    for (std::size_t c = 0; c < scene.cells.size(); ++c) {
      Box box;
      for (std::size_t a = 0; a < 3; ++a) {
        const std::int32_t one = word_of(static_cast<std::int32_t>(walk->words[walk->cell_addresses[c] + a].value)).twos_complement();
        const std::int32_t other = word_of(static_cast<std::int32_t>(walk->words[walk->cell_addresses[c] - 3 + a].value)).twos_complement();
        box.low[a] = std::min(one, other);
        box.high[a] = std::max(one, other);
      }
      EXPECT_EQ(box, scene.cells[c].box) << name << " cell " << c;
    }
  }
}

// A tape of the other kind does not assemble.
TEST(JonesWalkTape, IsForItsProgram) {
  const scene::CellScene house = scene::builtin_scene("house");
  for (const bool program_walks : {false, true}) {
    for (const Tape tape : {Tape::view, Tape::walk}) {
      std::vector<assembler::SourceFile> sources;
      for (const auto& [file, text] : firmware_tapes()) sources.push_back({std::string(file), std::string(text)});
      sources.push_back({"scene tape", *write_tape(house, {}, tape)});
      assembler::Options options;
      options.defines = {{"EAE", 1}, {"WALK", program_walks ? 1U : 0U}};
      EXPECT_EQ(assembler::assemble_pdp7(sources, options).ok(), program_walks == (tape == Tape::walk));
    }
  }
}

TEST(JonesWalkTape, RefusesCellsWithoutAPointInside) {
  scene::CellScene scene = scene::builtin_scene("house");
  scene.cells[1].box.high[0] = scene.cells[1].box.low[0] + 1;
  EXPECT_TRUE(encode(scene));
  const auto walk = encode(scene, {}, 0, Tape::walk);
  ASSERT_FALSE(walk);
  EXPECT_EQ(walk.error().place, "cell 1");
}

// The words that firmware/pdp7/jones/NOTES.md states, whose lines are broken anywhere.
TEST(JonesWalkTape, NotesStateTheWords) {
  std::ifstream file(SIGHTLINE_SOURCE_DIR "/firmware/pdp7/jones/NOTES.md");
  std::string notes;
  for (std::string word; file >> word;) notes += word + ' ';
  ASSERT_FALSE(notes.empty());
  const auto free_words = [](const char* scene, bool eae, bool walk) {
    const auto program = assemble_program(scene::builtin_scene(scene), {.eae = eae, .walk = walk});
    return core_words - program->words_used;
  };
  const auto states = [&](const std::string& text) { EXPECT_NE(notes.find(text), std::string::npos) << text; };
  const auto thousands = [](std::uint32_t number) {
    std::string text = std::to_string(number);
    if (text.size() > 3) text.insert(text.size() - 3, ",");
    return text;
  };
  const auto planes = [](const char* scene) { return std::to_string(3 * scene::builtin_scene(scene).cells.size()); };
  states("three words for each cell: " + planes("house") + " in house, " + planes("street4") + " in street4");
  states("without the walk leaves " + thousands(free_words("street4", true, false)) + " words free with the EAE and " +
         thousands(free_words("street4", false, false)) + " without");
  states(thousands(free_words("street4", true, true)) + " words stay free with the EAE and " + thousands(free_words("street4", false, true)) +
         " without; in house " + thousands(free_words("house", true, true)) + " and " + thousands(free_words("house", false, true)));
}

TEST(JonesWalkPath, ReadsSteps) {
  const auto walk = read_walk(" in 100,right 50  up 20 , out 0,left 65535 down 1 in 2");
  ASSERT_TRUE(walk) << walk.error().message();
  EXPECT_EQ(*walk, (std::vector<Move>{{{0, 0, 100}}, {{50, 20, 0}}, {{0, 0, 0}}, {{-65535, -1, 2}}}));
}

TEST(JonesWalkPath, ReadsTurns) {
  const auto walk = read_walk("turn-left 30 in 100, turn-right 360, up 2 turn-left 0");
  ASSERT_TRUE(walk) << walk.error().message();
  EXPECT_EQ(*walk, (std::vector<Move>{{{0, 0, 100}, -30}, {{}, 360}, {{0, 2, 0}, 0}}));
  EXPECT_TRUE(has_turn(*walk));
  EXPECT_FALSE(has_turn(std::vector<Move>{{{1, 2, 3}}}));
}

TEST(JonesWalkPath, NamesWhatIsWrong) {
  for (const auto& [text, found] : std::vector<std::pair<const char*, const char*>>{{"", "view 1 of the walk: found no direction"},
                                                                                     {"in 5,", "view 2 of the walk: found no direction"},
                                                                                     {"in 5,,up 2", "view 2 of the walk: found no direction"},
                                                                                     {"in", "found \"in\""},
                                                                                     {"north 5", "found \"north\""},
                                                                                     {"IN 5", "found \"IN\""},
                                                                                     {"in -5", "found \"in -5\""},
                                                                                     {"in 65536", "found \"in 65536\""},
                                                                                     {"in 5 up", "found \"up\""},
                                                                                     {"in 5 out 5", "\"out\" is a second direction along z"},
                                                                                     {"turn-left 361", "found \"turn-left 361\""},
                                                                                     {"turn 5", "found \"turn\""},
                                                                                     {"turn-left 5 turn-right 5", "\"turn-right\" is a second turn"}}) {
    const auto walk = read_walk(text);
    ASSERT_FALSE(walk) << text;
    EXPECT_NE(walk.error().message().find(found), std::string::npos) << walk.error().message();
  }
  std::string many = "in 1";
  for (int n = 0; n < 1000; ++n) many += ",in 1";
  EXPECT_FALSE(read_walk(many));
}

TEST(JonesWalkPath, NamesAxes) {
  EXPECT_EQ(axes_of(0), "");
  EXPECT_EQ(axes_of(2), "y");
  EXPECT_EQ(axes_of(5), "x and z");
  EXPECT_EQ(axes_of(7), "x, y and z");
}

}  // namespace
}  // namespace sightline::programs::jones
