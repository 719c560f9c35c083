// One run of a PDP-7 program: that being asked in between changes nothing, and what a run keeps of its
// strokes.
#include "host/guests/run/pdp7.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace sightline::harness {
namespace {

std::map<pdp7::Address, core::Word18> words_at(pdp7::Address address,
                                               std::initializer_list<std::uint32_t> words) {
  std::map<pdp7::Address, core::Word18> core;
  for (const std::uint32_t word : words) core[address++] = core::Word18(word);
  return core;
}

// Counts at 200 for ever, with the clock interrupting every 20 ms. Each interrupt starts the display again,
// whose data breaks fall between the counts; the tenth halts.
Pdp7Job busy_job() {
  Pdp7Job job;
  job.machine.display = type340::Options{};
  job.core = words_at(0, {0, 0600300});  // 0: what the interrupt stores; 1: JMP 300
  job.core[7] = core::Word18(0777777);   // the clock's counter: the next tick interrupts
  // LAC 203, IDLA, CLON, ION, ISZ 200, NOP, JMP 104
  job.core.merge(words_at(0100, {0200203, 0700606, 0700044, 0700042, 0440200, 0740000, 0600104}));
  // The count; interrupts still to come, -10; AC kept during one; where the display file is.
  job.core.merge(words_at(0200, {0, 0777766, 0, 0000400}));
  // DAC 202, CLC, DAC 7, CLON, LAC 203, IDLA, ISZ 201, SKP, HLT, LAC 202, ION, JMP I 0
  job.core.merge(words_at(0300, {0040202, 0750001, 0040007, 0700044, 0200203, 0700606, 0440201, 0741000,
                                 0740040, 0200202, 0700042, 0620000}));
  // Scale 1, intensity 7; y 400; x 400, lit; a vector of 100 to the right, lit; stop, without interrupt.
  job.core.merge(words_at(0400, {0020117, 0220400, 0102400, 0600100, 0002000}));
  job.start = 0100;
  return job;
}

void expect_same_state(const Pdp7Report& a, const Pdp7Report& b) {
  EXPECT_EQ(a.registers, b.registers);
  EXPECT_EQ(a.end, b.end);
  EXPECT_EQ(a.counts.instructions, b.counts.instructions);
  EXPECT_EQ(a.counts.machine_cycles, b.counts.machine_cycles);
  EXPECT_EQ(a.counts.stolen_cycles, b.counts.stolen_cycles);
  EXPECT_EQ(a.display_words, b.display_words);
  EXPECT_EQ(a.core, b.core);
}

void expect_same(const Pdp7Report& a, const Pdp7Report& b) {
  EXPECT_EQ(a.stop, b.stop);
  expect_same_state(a, b);
}

TEST(RunPdp7, BeingAskedInBetweenChangesNothing) {
  Pdp7Job job = busy_job();
  job.limits.instructions = 20'000'000;
  const Pdp7Report alone = run_pdp7(job);
  EXPECT_EQ(alone.stop, Stop::halt);
  EXPECT_EQ(alone.core[0201].value(), 0U);
  EXPECT_EQ(alone.passes_started, 11U);
  EXPECT_EQ(alone.passes, 10U);  // HLT cuts the last one short
  int asked = 0;
  // A counter that never comes to its end keeps the run going past several questions.
  job.core[0201] = core::Word18(0);
  const Pdp7Report long_alone = run_pdp7(job);
  EXPECT_EQ(long_alone.stop, Stop::instruction_limit);
  job.keep_running = [&asked](const Progress&) { return ++asked > 0; };
  const Pdp7Report in_between = run_pdp7(job);
  EXPECT_GE(asked, 3);
  expect_same(in_between, long_alone);
}

// What a run leaves behind: trace and strokes as text.
struct Watched {
  Pdp7Report report;
  std::string trace;
  std::string strokes;
};

Watched watch(Pdp7Job job) {
  Watched watched;
  job.trace = [&watched](std::string_view text) { watched.trace += text; };
  Screen::Wishes wishes;
  wishes.log = [&watched](std::string_view text) { watched.strokes += text; };
  Screen screen(wishes);
  job.screen = &screen;
  watched.report = run_pdp7(job);
  return watched;
}

TEST(RunPdp7, MovingThePenWhereItSeesNothingChangesNothing) {
  Pdp7Job job = busy_job();
  const Watched alone = watch(job);
  ASSERT_EQ(alone.report.stop, Stop::halt);
  // The display file never enables the pen, so even one that sees all of the screen has no effect.
  for (std::int64_t i = 0; i < 3000; ++i) {
    const core::Instant when = core::at_nanoseconds(i * 97'003);
    const type340::LightPen everywhere{.right = 1023, .top = 1023};
    job.pen_script.push_back({when, i % 3 == 0 ? std::optional(everywhere) : std::nullopt});
  }
  ASSERT_GT(job.pen_script.back().time, alone.report.end);
  const Watched moved = watch(job);
  expect_same(moved.report, alone.report);
  EXPECT_EQ(moved.trace, alone.trace);
  EXPECT_EQ(moved.strokes, alone.strokes);
  EXPECT_FALSE(alone.strokes.empty());
  job.limits.until = core::at_nanoseconds(50'000'000);
  const Watched cut = watch(job);
  EXPECT_EQ(cut.report.stop, Stop::time_limit);
  job.limits.until = core::never;
  job.limits.instructions = cut.report.counts.instructions;
  const Watched counted = watch(job);
  EXPECT_EQ(counted.report.stop, Stop::instruction_limit);
  expect_same_state(counted.report, cut.report);
  EXPECT_EQ(counted.trace, cut.trace);
}

// The numbers lines begin with.
std::vector<std::int64_t> first_fields(const std::string& text) {
  std::vector<std::int64_t> fields;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) fields.push_back(std::stoll(line));
  return fields;
}

// A single lit point, waited for with IDSP: the pen finds it if it was pointed at a boundary before the
// flash.
TEST(RunPdp7, ThePenMovesAtTheFirstBoundaryAtOrAfterItsTime) {
  Pdp7Job job;
  job.machine.display = type340::Options{};
  job.core = words_at(0100, {0200107, 0700606, 0700701, 0600102, 0740040});
  job.core.merge(words_at(0107, {0000110, 0034117, 0220400, 0002600, 0003000}));
  job.start = 0100;
  job.limits.instructions = 200;
  const Watched alone = watch(job);
  ASSERT_EQ(alone.report.stop, Stop::instruction_limit);
  const std::vector<std::int64_t> boundaries = first_fields(alone.trace);
  const std::vector<std::int64_t> flashes = first_fields(alone.strokes);
  ASSERT_EQ(flashes.size(), 1U);
  const std::int64_t flash = flashes[0];
  int found = 0;
  for (std::int64_t t = flash - 5000; t <= flash + 3000; t += 50) {
    const std::int64_t moved = *std::lower_bound(boundaries.begin(), boundaries.end(), t);
    job.pen_script = {{core::at_nanoseconds(t), type340::LightPen{.right = 1023, .top = 1023}}};
    const bool halted = run_pdp7(job).stop == Stop::halt;
    EXPECT_EQ(halted, moved < flash) << t << " " << moved << " " << flash;
    found += halted ? 1 : 0;
  }
  EXPECT_GT(found, 0);
  EXPECT_LT(found, 161);
}

TEST(RunPdp7, APenWithoutADisplayIsNothing) {
  Pdp7Job job = busy_job();
  job.machine.display = std::nullopt;
  job.limits.instructions = 1000;
  const Pdp7Report alone = run_pdp7(job);
  job.pen_script = {{core::at_nanoseconds(0), type340::LightPen{}}};
  expect_same(run_pdp7(job), alone);
}

TEST(RunPdp7, ATraceOrAScreenChangesNothing) {
  Pdp7Job job = busy_job();
  const Pdp7Report alone = run_pdp7(job);
  std::size_t traced = 0;
  job.trace = [&traced](std::string_view text) {
    traced += static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  };
  std::size_t logged = 0;
  Screen::Wishes wishes;
  wishes.log = [&logged](std::string_view text) { logged += text.size(); };
  Screen screen(wishes);
  job.screen = &screen;
  const Pdp7Report watched = run_pdp7(job);
  expect_same(watched, alone);
  EXPECT_EQ(traced, alone.counts.instructions);
  EXPECT_GT(logged, 0U);
}

TEST(RunPdp7, CanBeStopped) {
  Pdp7Job job;
  job.core = words_at(0, {0600000});
  int asked = 0;
  job.keep_running = [&asked](const Progress& progress) {
    EXPECT_GT(progress.instructions, 0U);
    return ++asked < 3;
  };
  const Pdp7Report report = run_pdp7(job);
  EXPECT_EQ(report.stop, Stop::interrupted);
  EXPECT_EQ(asked, 3);
}

TEST(RunPdp7, DumpOfFourThousandWords) {
  Pdp7Job job;
  job.machine.configuration.core_words = 4096;
  job.core = words_at(0, {0740040});
  job.core[07777] = core::Word18(0123456);
  job.registers.ac = core::Word18(0777777);
  job.registers.link = true;
  const std::string dump = dump_text(run_pdp7(job));
  EXPECT_TRUE(dump.starts_with("00001 777777 1 000000 00\n740040 000000 ")) << dump.substr(0, 60);
  EXPECT_TRUE(dump.ends_with(" 000000 123456\n"));
  EXPECT_EQ(dump.size(), 25U + 4096U * 7U);
}

TEST(Screen, KeepsTheLastCompletePassOrTheNewestStrokes) {
  const auto stroke = [](std::uint16_t x) { return core::Stroke{core::at_nanoseconds(x), x, 0, 7, 0}; };
  Screen::Wishes wishes;
  wishes.picture = true;
  Screen screen(wishes);
  screen.begin_pass(core::at_nanoseconds(0));
  screen.stroke(stroke(1));
  screen.begin_pass(core::at_nanoseconds(2));
  screen.stroke(stroke(2));
  EXPECT_FALSE(screen.has_complete_pass());
  EXPECT_EQ(screen.picture_strokes(), (std::vector{stroke(1), stroke(2)}));
  screen.end_pass(core::at_nanoseconds(3));
  screen.stroke(stroke(3));
  EXPECT_TRUE(screen.has_complete_pass());
  EXPECT_EQ(screen.picture_strokes(), std::vector{stroke(2)});
}

}  // namespace
}  // namespace sightline::harness
