// The program on the emulated PDP-7 compared with its native twin, word for word; and damaged tapes.
//
// SIGHTLINE_TURNS=10 in the environment runs ten whole turns of every model in both directions, and 1,000 random sequences.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "host/programs/turn/turn.hpp"
#include "tests/host/programs/turn/turned_model.hpp"
#include "tests/support/dice.hpp"
#include "tests/support/effort.hpp"

namespace sightline::programs::turn {
namespace {

using jones::Dice;

PicturesOrder at_speed(std::uint32_t switches, std::uint32_t pictures) {
  PicturesOrder order;
  order.pictures = pictures;
  order.switches = [switches](std::uint32_t) { return switches; };
  order.check = true;
  return order;
}

// Empty if every picture equals its twin's.
std::string fault_of(const base::Result<Pictures>& run) { return run ? "" : run.error().message(); }

void expect_twins(const std::string& name, Memory memory, bool tilted) {
  const TurnedModel& model = turned_model(name, memory, tilted);
  for (const bool eae : {true, false}) {
    const Program program = assemble_program(eae, memory);
    for (const std::uint32_t direction : {0U, backward_switch}) {
      // Steps that do not divide a turn: every turn has different angles.
      const std::uint32_t step = turns() > 1 ? 1637 : tests::effort(4391U, 20011U);
      const auto run = run_pictures(program, model.tape, at_speed(direction | step, turns() * pictures_of_turn(step)));
      EXPECT_EQ(fault_of(run), "") << name << (eae ? " with" : " without") << " EAE";
    }
    const auto wire = run_pictures(program, model.tape, at_speed(wire_switch | 7001, 38));
    EXPECT_EQ(fault_of(wire), "") << name;
  }
}

TEST(TurnGuest, EqualsItsTwinOverWholeTurns) {
  for (const std::string& name : {cube, block, crossed, lshape, star, std::string("roberts"), std::string("boxes-8")})
    expect_twins(name, Memory::words_8k, true);
}

TEST(TurnGuest, EqualsItsTwinIn32K) {
  expect_twins(block, Memory::words_32k, true);
  expect_twins(grid, Memory::words_32k, false);
}

// Random starts, speeds and switches: the first step may go anywhere.
TEST(TurnGuest, EqualsItsTwinForAnySwitches) {
  const unsigned sequences = turns() > 1 ? 100 * turns() : tests::effort(24U, 5U);
  constexpr std::uint32_t seed = 20261124;
  Dice dice(seed);
  const std::vector<std::string> names{block, crossed, lshape, star, "boxes-8"};
  for (unsigned n = 0; n < sequences; ++n) {
    const std::string& name = names[n % names.size()];
    const Tape& tape = turned_model(name).tape;
    std::vector<std::uint32_t> script;
    for (int k = 0; k < 30; ++k) {
      std::uint32_t switches = static_cast<std::uint32_t>(dice(0, 3) == 0 ? dice(1, 3) : dice(1, 32767));
      if (dice(0, 3) == 0) switches |= backward_switch;
      if (dice(0, 5) == 0) switches |= wire_switch;
      // When the switch for single events rises, a picture is made; it must be down in the picture before.
      if (dice(0, 3) == 0 && (script.empty() || (script.back() & single_switch) == 0)) switches |= single_switch;
      script.push_back(switches);
    }
    script[0] &= ~single_switch;
    PicturesOrder order = at_speed(0, static_cast<std::uint32_t>(script.size()));
    order.switches = [&script](std::uint32_t k) { return script[k]; };
    const auto run = run_pictures(assemble_program(n % 2 == 0, tape.memory), tape, order);
    ASSERT_EQ(fault_of(run), "") << name << ", sequence " << n << " of seed " << seed;
  }
}

TEST(TurnGuest, StopsWhenTheSpeedIsZero) {
  const Tape& tape = turned_model(cube).tape;
  Machine machine(assemble_program(true, tape.memory), tape);
  Picture picture;
  ASSERT_TRUE(machine.next(0, picture));
  EXPECT_FALSE(machine.next(0, picture, core::milliseconds(100)));
  EXPECT_FALSE(machine.halted());
  ASSERT_TRUE(machine.next(64, picture));
  EXPECT_EQ(picture.angle, 64U);
}

// Positions depend only on the angle: after a thousand turns the picture is the same.
TEST(TurnGuest, DoesNotDrift) {
  const Tape& tape = turned_model(block).tape;
  constexpr std::uint32_t step = 1U << 14U;
  const std::uint32_t count = 16U * (turns() > 1 ? 1000U : tests::effort(40U, 3U));
  Machine machine(assemble_program(true, tape.memory), tape);
  Picture picture;
  std::vector<std::vector<core::Word18>> first(16);
  for (std::uint32_t k = 0; k < count; ++k) {
    ASSERT_TRUE(machine.next(step, picture));
    if (k < 16) first[k] = picture.display_file;
    ASSERT_EQ(picture.display_file, first[k % 16]) << k;
  }
}

// The tape in the reader gives the same picture as its words in core.
TEST(TurnGuest, ReadsItsTape) {
  for (const Memory memory : {Memory::words_8k, Memory::words_32k}) {
    const Tape& tape = turned_model(cube, memory).tape;
    Machine machine(assemble_program(true, memory), punch(tape));
    Picture picture;
    ASSERT_TRUE(machine.next(0, picture, core::seconds(20)));
    Twin twin(tape.words, model_base(memory));
    TwinPicture expected;
    ASSERT_TRUE(twin.next(0, expected));
    EXPECT_EQ(difference_of(picture, expected), "");
  }
}

TEST(TurnGuest, RejectsADamagedTape) {
  const Tape& tape = turned_model(cube).tape;
  const Program program = assemble_program(true, tape.memory);
  const base::Bytes whole = punch(tape);
  Picture picture;
  Dice dice(7);
  for (int n = 0; n < tests::effort(12, 3); ++n) {
    base::Bytes damaged = whole;
    // Changes one data hole of a word of the model or of its sum; the count has a separate test.
    damaged[static_cast<std::size_t>(dice(6, static_cast<int>(whole.size()) - 1))] ^= static_cast<std::uint8_t>(1U << dice(0, 5));
    Machine machine(program, damaged);
    EXPECT_FALSE(machine.next(0, picture, core::seconds(20)));
    EXPECT_TRUE(machine.halted());
    EXPECT_EQ(machine.status(), Status::wrong_sum) << n;
  }
  {
    base::Bytes cut(whole.begin(), whole.end() - 30);
    Machine machine(program, cut);
    EXPECT_FALSE(machine.next(0, picture, core::seconds(20)));
    EXPECT_FALSE(machine.halted());
    EXPECT_EQ(machine.status(), Status::reading);
  }
  {
    base::Bytes count = whole;
    count[0] = 0277;  // negative
    Machine machine(program, count);
    EXPECT_FALSE(machine.next(0, picture, core::seconds(20)));
    EXPECT_TRUE(machine.halted());
    EXPECT_EQ(machine.status(), Status::other_tape);
  }
  {
    Machine machine(program, punch(turned_model(cube, Memory::words_32k).tape));
    EXPECT_FALSE(machine.next(0, picture, core::seconds(20)));
    EXPECT_EQ(machine.status(), Status::other_tape);
  }
}

TEST(TurnGuest, ShowsThePartThatFitsAFullDisplayFile) {
  Tape tape = turned_model(star).tape;
  constexpr std::uint32_t header_file_words = 11;
  tape.words[header_file_words] = core::Word18(60);
  for (const bool eae : {true, false}) {
    PicturesOrder order = at_speed(500, 20);
    order.display_files = true;
    const auto run = run_pictures(assemble_program(eae, tape.memory), tape, order);
    ASSERT_EQ(fault_of(run), "");
    ASSERT_EQ(run->pictures.size(), 20U);
    for (const Picture& picture : run->pictures) {
      EXPECT_EQ(picture.status, Status::file_full);
      EXPECT_LE(picture.display_file.size(), 60U);
      EXPECT_GT(picture.display_file.size(), 40U);
    }
  }
}

// Files of all sizes from too small for one line: some pictures of a turn fit and some do not, and each has its own status.
TEST(TurnGuest, HasAStatusForEachPicture) {
  const Tape whole = turned_model(block).tape;
  bool mixed = false;
  for (std::uint32_t size = 20; size < whole.file_words; size += tests::effort(3U, 16U)) {
    Tape tape = whole;
    tape.words[11] = core::Word18(size);
    const auto run = run_pictures(assemble_program(size % 2 == 0, tape.memory), tape, at_speed(9001, 30));
    ASSERT_EQ(fault_of(run), "") << size << " words";
    const auto full = std::count_if(run->pictures.begin(), run->pictures.end(), [](const Picture& p) { return p.status == Status::file_full; });
    mixed = mixed || (full > 0 && full < 30);
  }
  EXPECT_TRUE(mixed);
}

// Two display files instead of three: the same pictures, later.
TEST(TurnGuest, WorksWithTwoDisplayFiles) {
  Tape tape = turned_model(block).tape;
  constexpr std::uint32_t header_files = 12;
  tape.words[header_files] = core::Word18(2);
  const Program program = assemble_program(true, tape.memory);
  const auto two = run_pictures(program, tape, at_speed(700, 100));
  ASSERT_EQ(fault_of(two), "");
  const auto three = run_pictures(program, turned_model(block).tape, at_speed(700, 100));
  ASSERT_EQ(fault_of(three), "");
  EXPECT_LT(two->summary.frames_per_second_mean, three->summary.frames_per_second_mean);
}

// The goal: a turn in 8 seconds.
TEST(TurnGuest, IsFastEnough) {
  NEEDS_OPTIMISED_CODE();
  struct Goal {
    std::string name;
    bool eae;
    double worst;
    double ratio;
  };
  for (const Goal& goal : {Goal{block, true, 40, 1.0}, Goal{block, false, 20, 0}, Goal{"roberts", true, 40, 1.0},
                           Goal{"roberts", false, 20, 0}, Goal{star, true, 20, 1.6}, Goal{star, false, 8, 0}}) {
    const Tape& tape = turned_model(goal.name).tape;
    const Program program = assemble_program(goal.eae, tape.memory);
    const std::uint32_t step = *step_for(program, tape, 8, false);
    const auto hidden = run_pictures(program, tape, at_speed(step, pictures_of_turn(step)))->summary;
    EXPECT_GE(hidden.frames_per_second_worst, goal.worst) << goal.name << goal.eae;
    EXPECT_NEAR((1 << 18) / (step * hidden.frames_per_second_mean), 8, 0.2) << goal.name << goal.eae;
    if (goal.ratio != 0) {
      const auto wire = run_pictures(program, tape, at_speed(step | wire_switch, 60))->summary;
      EXPECT_LE(wire.frames_per_second_mean / hidden.frames_per_second_mean, goal.ratio) << goal.name;
    }
    if (goal.name == star) {
      EXPECT_GE(hidden.junctions_mean, 20);
    }
  }
}

// Programs with one wrong bit: checked pictures either fail or are those of the right program.
TEST(TurnGuest, ACheckedRunOfAWrongProgramFails) {
  const TurnedModel& model = turned_model(cube, Memory::words_8k, true);
  Program program = assemble_program(true, Memory::words_8k);
  PicturesOrder order = at_speed(9001, 5);
  order.display_files = true;
  const auto right = run_pictures(program, model.tape, order);
  ASSERT_TRUE(right) << right.error().message();
  int differences = 0;
  for (std::size_t at = 3; at < program.core.size(); at += tests::effort(29U, 211U)) {
    const core::Word18 word = program.core[at];
    if (word.value() == 0) continue;
    program.core[at] = core::Word18(word.value() ^ 1U);
    const auto wrong = run_pictures(program, model.tape, order);
    program.core[at] = word;
    if (!wrong) {
      differences += wrong.error().kind == base::ErrorKind::differs ? 1 : 0;
      continue;
    }
    ASSERT_EQ(wrong->pictures.size(), right->pictures.size());
    for (std::size_t i = 0; i < right->pictures.size(); ++i)
      EXPECT_EQ(wrong->pictures[i].display_file, right->pictures[i].display_file) << "word " << at << ", picture " << i;
  }
  EXPECT_GT(differences, 0);
}

}  // namespace
}  // namespace sightline::programs::turn
