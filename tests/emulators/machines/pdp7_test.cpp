// The whole PDP-7: programs that use its devices, interrupts, data breaks, limits, counters and observers.
#include "emulators/machines/pdp7.hpp"

#include <gtest/gtest.h>

#include <initializer_list>
#include <utility>
#include <vector>

#include "emulators/core/stroke.hpp"
#include "emulators/machines/basic_pdp7.hpp"
#include "tests/emulators/machines/fake_display.hpp"
#include "tests/emulators/machines/recording_observer.hpp"

namespace sightline {
namespace {

using machines::StopReason;
using Machine = machines::BasicPdp7<tests::FakeDisplay>;
using Recorded = machines::BasicPdp7<tests::FakeDisplay, tests::RecordingObserver>;

template <class M>
void load(M& machine, pdp7::Address at, std::initializer_list<std::uint32_t> words) {
  for (const std::uint32_t word : words) machine.deposit(at++, core::Word18(word));
}

class Pdp7 : public testing::Test {
 protected:
  machines::NoObserver none_;
  tests::RecordingObserver recorder_;
};

// Adds 1 to 11 with an auto-index pointer; uses nothing it has not set.
constexpr std::initializer_list<std::uint32_t> sum_program{
    0750000, 0040200, 0765300, 0040010, 0777765, 0040201,                    // sum, pointer, counter -11
    0200202, 0340203, 0040202, 0060010, 0340200, 0040200, 0440201, 0600106,  // n+1; store; sum; count
    0740040};

TEST_F(Pdp7, PowerOnCoreDoesNotChangeAProgramThatSetsItsData) {
  std::vector<std::uint32_t> sums;
  for (const std::uint64_t seed : {1U, 2U, 77U}) {
    Machine machine({}, none_);
    machine.randomise_core(seed);
    load(machine, 0100, sum_program);
    load(machine, 0202, {0, 1});
    machine.start(0100);
    EXPECT_EQ(machine.run({1000, core::never}), StopReason::halt);
    sums.push_back(machine.peek(0200).value());
    sums.push_back(static_cast<std::uint32_t>(core::nanoseconds_of(machine.now()) / 1750));
  }
  EXPECT_EQ(sums[0], 1U + 2 + 3 + 4 + 5 + 6 + 7 + 8 + 9 + 10 + 11);
  EXPECT_EQ(sums[2], sums[0]);
  EXPECT_EQ(sums[4], sums[0]);
  EXPECT_EQ(sums[3], sums[1]);
}

// RSA, wait on the flag, RRB, store through 10; three lines, then HLT. Tape time rules.
TEST_F(Pdp7, AProgramReadsATapeByPolling) {
  Machine machine({}, none_);
  machine.devices().reader.load({0101, 0202, 0303});
  load(machine, 0100, {0700104, 0700101, 0600101, 0700112, 0060010, 0440200, 0600100, 0740040});
  load(machine, 0200, {0777775});
  load(machine, 010, {0277});
  machine.start(0100);
  EXPECT_EQ(machine.run({}), StopReason::halt);
  EXPECT_EQ(machine.peek(0300).value(), 0101U);
  EXPECT_EQ(machine.peek(0302).value(), 0303U);
  EXPECT_GT(core::nanoseconds_of(machine.now()), 3 * 3'333'333);
  EXPECT_LT(core::nanoseconds_of(machine.now()), 3 * 3'400'000);
}

// The background counts; the handler reads each key, stores it and returns with ION; JMP I 0.
TEST_F(Pdp7, KeysInterruptACountingProgram) {
  Machine machine({}, none_);
  load(machine, 0, {0, 0040020, 0700312, 0060010, 0200020, 0700042, 0620000});
  load(machine, 0100, {0700042, 0440200, 0600101, 0600101});
  load(machine, 010, {0277});
  for (const char key : {'J', 'O', 'N'})
    machine.devices().keyboard.press(core::at_nanoseconds(0), static_cast<std::uint8_t>(key));
  machine.start(0100);
  EXPECT_EQ(machine.run({~std::uint64_t{0}, core::at_nanoseconds(350'000'000)}), StopReason::time_limit);
  EXPECT_EQ(machine.peek(0300).value(), 0312U);
  EXPECT_EQ(machine.peek(0301).value(), 0317U);
  EXPECT_EQ(machine.peek(0302).value(), 0316U);
  EXPECT_EQ(machine.peek(010).value(), 0302U);
  EXPECT_TRUE(machine.registers().interrupts_on);
}

// Half a second of 50 Hz clock: 25 counts, 25 stolen cycles, nothing else moved.
TEST_F(Pdp7, TheClockCountsLocationSevenInStolenCycles) {
  Machine machine({}, none_);
  load(machine, 0100, {0700044, 0600101});
  machine.start(0100);
  machine.run({~std::uint64_t{0}, core::at_nanoseconds(510'000'000)});
  EXPECT_EQ(machine.peek(7).value(), 25U);
  const auto counts = machine.counts();
  EXPECT_EQ(counts.stolen_cycles, 25U);
  EXPECT_EQ(counts.machine_cycles, counts.instructions + 25);
  EXPECT_EQ(core::nanoseconds_of(machine.now()), static_cast<std::int64_t>(counts.machine_cycles) * 1750);
}

TEST_F(Pdp7, EveryWordOfADisplayFileCostsOneCycle) {
  Machine machine({}, none_);
  auto& display = machine.attach_display(core::Duration(5000));
  load(machine, 0100, {0200200, 0700606, 0740000, 0600102});
  load(machine, 0200, {0760300});  // bits above the address are ignored
  load(machine, 0300, {1, 2, 3, 4, 0777777});
  machine.start(0100);
  machine.run({100, core::never});
  ASSERT_EQ(display.deliveries.size(), 5U);
  EXPECT_EQ(display.deliveries[0].word.value(), 1U);
  EXPECT_EQ(display.deliveries[4].word.value(), 0777777U);
  for (const auto& d : display.deliveries) {
    EXPECT_GE(d.at - d.since, pdp7::machine_cycle);
    EXPECT_LT(d.at - d.since, pdp7::machine_cycle * 3);
  }
  EXPECT_EQ(machine.counts().stolen_cycles, 5U);
  EXPECT_EQ(machine.counts().machine_cycles, 100U + 1 + 5);  // 99 of one cycle, LAC of two
}

TEST_F(Pdp7, TheDisplayInterruptsWhenItStopsAndItsIotsReadIt) {
  Machine machine({}, none_);
  auto& display = machine.attach_display(core::Duration(5000));
  load(machine, 1, {0700601, 0740040, 0700512, 0040400, 0700712, 0040401, 0701012, 0040402, 0740040});
  load(machine, 0100, {0200200, 0700606, 0700042, 0600103});
  load(machine, 0200, {0300});
  load(machine, 0300, {1, 0777777});
  machine.start(0100);
  EXPECT_EQ(machine.run({1000, core::never}), StopReason::halt);
  EXPECT_EQ(machine.registers().pc, 012U);
  EXPECT_EQ(machine.peek(0400).value(), 0302U);
  EXPECT_EQ(machine.peek(0401).value(), 0123456U);
  EXPECT_EQ(machine.peek(0402).value(), 0654321U);
  EXPECT_EQ(machine.peek(0).value(), 0103U);
  display.edge_flags = display.pen_flag = true;
  load(machine, 0500, {0700501, 0740040, 0701001, 0740040, 0700701, 0740040, 0700504, 0700314, 0740040});
  machine.start(0500);
  EXPECT_EQ(machine.run({100, core::never}), StopReason::halt);
  EXPECT_EQ(machine.registers().pc, 0511U);
  EXPECT_TRUE(display.resumed);
  EXPECT_EQ(machine.registers().ac.value(), pdp7::status::light_pen);
}

TEST_F(Pdp7, UnansweredInstructionsAreCountedWithTheirFirstPlace) {
  machines::Configuration bare;
  bare.model.eae = false;
  Machine machine(bare, none_);
  load(machine, 0100, {0704501, 0653122, 0700606, 0707702, 0600100});
  machine.start(0100);
  machine.run({10, core::never});
  ASSERT_EQ(machine.unanswered().size(), 4U);
  EXPECT_EQ(machine.unanswered()[0].word, 0704501U);
  EXPECT_EQ(machine.unanswered()[1].word, 0653122U);
  EXPECT_EQ(machine.unanswered()[1].count, 2U);
  EXPECT_EQ(machine.unanswered()[1].first_pc, 0101U);
  EXPECT_EQ(machine.unanswered()[2].word, 0700606U);
  EXPECT_EQ(machine.unanswered()[3].word, 0707702U);
  EXPECT_EQ(machine.counts().machine_cycles, 10U);
}

TEST_F(Pdp7, StrictStopsAtAnUnansweredInstruction) {
  machines::Configuration strict;
  strict.model.strict = true;
  Machine machine(strict, none_);
  load(machine, 0100, {0740000, 0700606, 0740040});
  machine.start(0100);
  EXPECT_EQ(machine.run({}), StopReason::unanswered);
  EXPECT_EQ(machine.registers().pc, 0102U);
}

TEST_F(Pdp7, LimitsStopAtAnInstructionBoundary) {
  Machine machine({}, none_);
  load(machine, 0100, {0200200, 0600100});
  machine.start(0100);
  EXPECT_EQ(machine.run({3, core::never}), StopReason::instruction_limit);
  EXPECT_EQ(machine.counts().instructions, 3U);
  EXPECT_EQ(core::nanoseconds_of(machine.now()), 5 * 1750);
  EXPECT_EQ(machine.run({~std::uint64_t{0}, core::at_nanoseconds(10'000)}), StopReason::time_limit);
  EXPECT_EQ(core::nanoseconds_of(machine.now()), 10'500);
  EXPECT_EQ(machine.run({0, core::never}), StopReason::instruction_limit);
  EXPECT_EQ(core::nanoseconds_of(machine.now()), 10'500);
}

// Run one instruction at a time, ION still protects the one after it.
TEST_F(Pdp7, SingleStepsGiveTheSameRunAsOneRun) {
  std::vector<pdp7::State> ends;
  for (const std::uint64_t at_a_time : {1U, 2U, 3U, 12U}) {
    Recorded machine({}, recorder_);
    machine.attach_display(core::Duration(4000)).keeps_deliveries = false;
    load(machine, 1, {0740000, 0700042, 0620000});
    load(machine, 0100, {0200200, 0700606, 0700042, 0440201, 0600103});
    load(machine, 0200, {0300});
    load(machine, 0300, {0, 0777777});
    machine.start(0100);
    for (std::uint64_t done = 0; done < 12; done += at_a_time) machine.run({at_a_time, core::never});
    ends.push_back(machine.registers());
    EXPECT_EQ(machine.counts().instructions, 12U);
  }
  for (const auto& end : ends) EXPECT_EQ(end, ends[0]);
}

TEST_F(Pdp7, AnObserverSeesEveryInstructionAndStopsTheRun) {
  Recorded machine({}, recorder_);
  recorder_.stop_on_write = 0201;
  load(machine, 0100, {0760001, 0040200, 0040201, 0040202, 0740040});
  machine.start(0100);
  EXPECT_EQ(machine.run({}), StopReason::observer);
  EXPECT_EQ(machine.registers().pc, 0103U);
  ASSERT_EQ(recorder_.steps.size(), 3U);
  EXPECT_EQ(recorder_.steps[1].pc, 0101U);
  EXPECT_EQ(recorder_.steps[1].word.value(), 0040200U);
  EXPECT_EQ(core::nanoseconds_of(recorder_.steps[1].time), 1750);
  EXPECT_EQ(core::nanoseconds_of(recorder_.steps[1].end), 5250);
  EXPECT_EQ(recorder_.steps[0].after.ac.value(), 0760001U);
  EXPECT_EQ(machine.run({}), StopReason::halt);
}

TEST_F(Pdp7, AStretchedIotTakesItsTimeButNoMachineCycle) {
  machines::Configuration slow;
  slow.timing.iot_stretch[003] = core::Duration(500);
  slow.timing.interrupt_cycles = 2;
  Machine machine(slow, none_);
  load(machine, 0100, {0700314, 0740040});
  machine.start(0100);
  machine.run({});
  EXPECT_EQ(core::nanoseconds_of(machine.now()), 2 * 1750 + 500);
  EXPECT_EQ(machine.counts().machine_cycles, 2U);
}

// A real Type 340 runs the worked file of its reference and stops with an interrupt: 7 words, 534.6 us of its
// own time and what each word waits for the processor.
TEST_F(Pdp7, ARealDisplayRunsItsFileWhileTheProcessorCounts) {
  machines::Pdp7<> machine({{}, type340::Options{}}, none_);
  load(machine, 1, {0740040});
  load(machine, 0100, {0200200, 0700606, 0700042, 0600103});
  load(machine, 0200, {01000});
  load(machine, 01000, {0020117, 0220400, 0100400, 0200144, 0236000, 0600344, 0003000});
  machine.start(0100);
  EXPECT_EQ(machine.run({}), StopReason::halt);
  EXPECT_EQ(machine.counts().stolen_cycles, 7U);
  EXPECT_EQ(machine.display()->counters().words, 7U);
  EXPECT_EQ(machine.display()->counters().passes_stopped, 1U);
  const std::int64_t started = 3 * 1750;
  const std::int64_t elapsed = core::nanoseconds_of(machine.now()) - started;
  EXPECT_GE(elapsed, 534'600 + 7 * 1750);
  EXPECT_LE(elapsed, 534'600 + 7 * 2 * 1750 + 4 * 1750);
}

// A real Type 340 with the 347 option: mode 7 at 300, DDS 350 at 301, stop at 302. A word takes 3.3 us, a
// break waits for the end of the JMP: asked for at 5250, 10300, 15550 (the write) and, as the deposit is
// done, at 17500.
TEST_F(Pdp7, ADepositOfTheRealDisplayIsFollowedAtOnceByItsNextWord) {
  type340::Options options;
  options.subroutines_347 = true;
  machines::Pdp7<tests::RecordingObserver> machine({{}, options}, recorder_);
  load(machine, 0100, {0200200, 0700606, 0600102});
  load(machine, 0200, {0300});
  load(machine, 0300, {0160000, 0200350, 0003000});
  machine.start(0100);
  machine.run({20, core::never});
  std::vector<std::vector<std::int64_t>> breaks;
  for (const pdp7::Cycle& c : recorder_.events) {
    if (c.verb != pdp7::Verb::break_read && c.verb != pdp7::Verb::break_write) continue;
    breaks.push_back(
        {core::nanoseconds_of(c.time), c.verb == pdp7::Verb::break_write ? 1 : 0, c.address, c.data.value()});
  }
  const std::vector<std::vector<std::int64_t>> expected{{5250, 0, 0300, 0160000},
                                                        {10500, 0, 0301, 0200350},
                                                        {15750, 1, 0350, 0400000},
                                                        {17500, 0, 0302, 0003000}};
  EXPECT_EQ(breaks, expected);
  EXPECT_EQ(machine.peek(0350).value(), 0400000U);
  EXPECT_TRUE(machine.display()->stop_interrupt(machine.now()));
}

}  // namespace
}  // namespace sightline
