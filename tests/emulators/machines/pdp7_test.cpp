// The whole PDP-7: programs that use its devices, interrupts, data breaks, limits, counters and observers.
#include "emulators/machines/pdp7.hpp"

#include <gtest/gtest.h>

#include <array>
#include <initializer_list>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "emulators/core/stroke.hpp"
#include "emulators/machines/pdp7_devices.hpp"
#include "emulators/pdp7/status.hpp"
#include "tests/emulators/machines/fake_display.hpp"
#include "tests/emulators/machines/recording_observer.hpp"

namespace sightline {
namespace {

using pdp7::Machine;
using pdp7::StopReason;

class Pdp7 : public testing::Test {
 protected:
  // Attaches a test display in place of the real one.
  static tests::FakeDisplay& attach_display(Machine& machine, core::Duration period) {
    auto display = std::make_unique<tests::FakeDisplay>(period);
    tests::FakeDisplay& attached = *display;
    EXPECT_EQ(machine.attach(tests::FakeDisplay::info, std::move(display)), "");
    return attached;
  }

  tests::RecordingObserver recorder_;
};

// Adds 1 to 11 with an auto-index pointer; reads only words that it has set.
constexpr std::initializer_list<std::uint32_t> sum_program{
    0750000, 0040200, 0765300, 0040010, 0777765, 0040201,                    // sum, pointer, counter -11
    0200202, 0340203, 0040202, 0060010, 0340200, 0040200, 0440201, 0600106,  // n+1; store; sum; count
    0740040};

TEST_F(Pdp7, PowerOnCoreDoesNotChangeAProgramThatSetsItsData) {
  std::vector<std::uint32_t> sums;
  for (const std::uint64_t seed : {1U, 2U, 77U}) {
    Machine machine;
    machine.randomise_core(seed);
    machine.load(0100, sum_program);
    machine.load(0202, {0, 1});
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

// RSA, wait for the flag, RRB, store through 10; three lines, then HLT. The tape determines the time.
TEST_F(Pdp7, AProgramReadsATapeByPolling) {
  Machine machine;
  machine.find<pdp7::Reader>()->load({0101, 0202, 0303});
  machine.load(0100, {0700104, 0700101, 0600101, 0700112, 0060010, 0440200, 0600100, 0740040});
  machine.load(0200, {0777775});
  machine.load(010, {0277});
  machine.start(0100);
  EXPECT_EQ(machine.run({}), StopReason::halt);
  EXPECT_EQ(machine.peek(0300).value(), 0101U);
  EXPECT_EQ(machine.peek(0302).value(), 0303U);
  EXPECT_GT(core::nanoseconds_of(machine.now()), 3 * 3'333'333);
  EXPECT_LT(core::nanoseconds_of(machine.now()), 3 * 3'400'000);
}

// The main program counts; the handler reads each key, stores it and returns with ION; JMP I 0.
TEST_F(Pdp7, KeysInterruptACountingProgram) {
  Machine machine;
  machine.load(0, {0, 0040020, 0700312, 0060010, 0200020, 0700042, 0620000});
  machine.load(0100, {0700042, 0440200, 0600101, 0600101});
  machine.load(010, {0277});
  for (const char key : {'J', 'O', 'N'})
    machine.find<pdp7::Keyboard>()->press(core::at_nanoseconds(0), static_cast<std::uint8_t>(key));
  machine.start(0100);
  EXPECT_EQ(machine.run({~std::uint64_t{0}, core::at_nanoseconds(350'000'000)}), StopReason::time_limit);
  EXPECT_EQ(machine.peek(0300).value(), 0312U);
  EXPECT_EQ(machine.peek(0301).value(), 0317U);
  EXPECT_EQ(machine.peek(0302).value(), 0316U);
  EXPECT_EQ(machine.peek(010).value(), 0302U);
  EXPECT_TRUE(machine.registers().interrupts_on);
}

// Half a second of 50 Hz clock: 25 counts, 25 stolen cycles, no other change.
TEST_F(Pdp7, TheClockCountsLocationSevenInStolenCycles) {
  Machine machine;
  machine.load(0100, {0700044, 0600101});
  machine.start(0100);
  machine.run({~std::uint64_t{0}, core::at_nanoseconds(510'000'000)});
  EXPECT_EQ(machine.peek(7).value(), 25U);
  const auto counts = machine.counts();
  EXPECT_EQ(counts.stolen_cycles, 25U);
  EXPECT_EQ(counts.machine_cycles, counts.instructions + 25);
  EXPECT_EQ(core::nanoseconds_of(machine.now()), static_cast<std::int64_t>(counts.machine_cycles) * 1750);
}

TEST_F(Pdp7, EveryWordOfADisplayFileCostsOneCycle) {
  Machine machine;
  auto& display = attach_display(machine, core::Duration(5000));
  machine.load(0100, {0200200, 0700606, 0740000, 0600102});
  machine.load(0200, {0760300});  // bits above the address are ignored
  machine.load(0300, {1, 2, 3, 4, 0777777});
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
  Machine machine;
  auto& display = attach_display(machine, core::Duration(5000));
  machine.load(1, {0700601, 0740040, 0700512, 0040400, 0700712, 0040401, 0701012, 0040402, 0740040});
  machine.load(0100, {0200200, 0700606, 0700042, 0600103});
  machine.load(0200, {0300});
  machine.load(0300, {1, 0777777});
  machine.start(0100);
  EXPECT_EQ(machine.run({1000, core::never}), StopReason::halt);
  EXPECT_EQ(machine.registers().pc, 012U);
  EXPECT_EQ(machine.peek(0400).value(), 0302U);
  EXPECT_EQ(machine.peek(0401).value(), 0123456U);
  EXPECT_EQ(machine.peek(0402).value(), 0654321U);
  EXPECT_EQ(machine.peek(0).value(), 0103U);
  display.edge_flags = display.pen_flag = true;
  machine.load(0500, {0700501, 0740040, 0701001, 0740040, 0700701, 0740040, 0700504, 0700314, 0740040});
  machine.start(0500);
  EXPECT_EQ(machine.run({100, core::never}), StopReason::halt);
  EXPECT_EQ(machine.registers().pc, 0511U);
  EXPECT_TRUE(display.resumed);
  EXPECT_EQ(machine.registers().ac.value(), pdp7::status::light_pen);
}

TEST_F(Pdp7, UnansweredInstructionsAreCountedWithTheirFirstAddress) {
  pdp7::Options bare;
  bare.model.eae = false;
  Machine machine(bare);
  machine.load(0100, {0704501, 0653122, 0700606, 0707702, 0600100});
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
  pdp7::Options strict;
  strict.model.strict = true;
  Machine machine(strict);
  machine.load(0100, {0740000, 0700606, 0740040});
  machine.start(0100);
  EXPECT_EQ(machine.run({}), StopReason::unanswered);
  EXPECT_EQ(machine.registers().pc, 0102U);
}

TEST_F(Pdp7, LimitsStopAtAnInstructionBoundary) {
  Machine machine;
  machine.load(0100, {0200200, 0600100});
  machine.start(0100);
  EXPECT_EQ(machine.run({3, core::never}), StopReason::instruction_limit);
  EXPECT_EQ(machine.counts().instructions, 3U);
  EXPECT_EQ(core::nanoseconds_of(machine.now()), 5 * 1750);
  EXPECT_EQ(machine.run({~std::uint64_t{0}, core::at_nanoseconds(10'000)}), StopReason::time_limit);
  EXPECT_EQ(core::nanoseconds_of(machine.now()), 10'500);
  EXPECT_EQ(machine.run({0, core::never}), StopReason::instruction_limit);
  EXPECT_EQ(core::nanoseconds_of(machine.now()), 10'500);
}

// In single steps ION still protects the instruction after it.
TEST_F(Pdp7, SingleStepsGiveTheSameRunAsOneRun) {
  std::vector<pdp7::State> ends;
  for (const std::uint64_t at_a_time : {1U, 2U, 3U, 12U}) {
    Machine machine;
    attach_display(machine, core::Duration(4000)).keeps_deliveries = false;
    machine.load(1, {0740000, 0700042, 0620000});
    machine.load(0100, {0200200, 0700606, 0700042, 0440201, 0600103});
    machine.load(0200, {0300});
    machine.load(0300, {0, 0777777});
    machine.start(0100);
    for (std::uint64_t done = 0; done < 12; done += at_a_time) machine.run({at_a_time, core::never}, recorder_);
    ends.push_back(machine.registers());
    EXPECT_EQ(machine.counts().instructions, 12U);
  }
  for (const auto& end : ends) EXPECT_EQ(end, ends[0]);
}

TEST_F(Pdp7, AnObserverSeesEveryInstructionAndStopsTheRun) {
  Machine machine;
  recorder_.stop_on_write = 0201;
  machine.load(0100, {0760001, 0040200, 0040201, 0040202, 0740040});
  machine.start(0100);
  EXPECT_EQ(machine.run({}, recorder_), StopReason::observer);
  EXPECT_EQ(machine.registers().pc, 0103U);
  ASSERT_EQ(recorder_.steps.size(), 3U);
  EXPECT_EQ(recorder_.steps[1].pc, 0101U);
  EXPECT_EQ(recorder_.steps[1].word.value(), 0040200U);
  EXPECT_EQ(core::nanoseconds_of(recorder_.steps[1].time), 1750);
  EXPECT_EQ(core::nanoseconds_of(recorder_.steps[1].end), 5250);
  EXPECT_EQ(recorder_.steps[0].after.ac.value(), 0760001U);
  EXPECT_EQ(machine.run({}, recorder_), StopReason::halt);
}

TEST_F(Pdp7, AStretchedIotTakesItsTimeButNoMachineCycle) {
  pdp7::Options slow;
  slow.timing.iot_stretch[003] = core::Duration(500);
  slow.timing.interrupt_cycles = 2;
  Machine machine(slow);
  machine.load(0100, {0700314, 0740040});
  machine.start(0100);
  machine.run({});
  EXPECT_EQ(core::nanoseconds_of(machine.now()), 2 * 1750 + 500);
  EXPECT_EQ(machine.counts().machine_cycles, 2U);
}

// A real Type 340 runs the worked file of its reference and stops with an interrupt: 7 words, 534.6 us of its
// own time and what each word waits for the processor.
TEST_F(Pdp7, ARealDisplayRunsItsFileWhileTheProcessorCounts) {
  Machine machine;
  ASSERT_EQ(machine.attach("display"), "");
  machine.load(1, {0740040});
  machine.load(0100, {0200200, 0700606, 0700042, 0600103});
  machine.load(0200, {01000});
  machine.load(01000, {0020117, 0220400, 0100400, 0200144, 0236000, 0600344, 0003000});
  machine.start(0100);
  EXPECT_EQ(machine.run({}), StopReason::halt);
  EXPECT_EQ(machine.counts().stolen_cycles, 7U);
  EXPECT_EQ(machine.find<type340::Display>()->counters().words, 7U);
  EXPECT_EQ(machine.find<type340::Display>()->counters().passes_stopped, 1U);
  const std::int64_t started = 3 * 1750;
  const std::int64_t elapsed = core::nanoseconds_of(machine.now()) - started;
  EXPECT_GE(elapsed, 534'600 + 7 * 1750);
  EXPECT_LE(elapsed, 534'600 + 7 * 2 * 1750 + 4 * 1750);
}

// A real Type 340 with the 347 option: mode 7 at 300, DDS 350 at 301, stop at 302. A word takes 3.3 us, and a break waits for the
// end of the JMP. Requests come at 5250, 10300, 15550 (the write) and, when the deposit is done, at 17500.
TEST_F(Pdp7, ADepositOfTheRealDisplayIsFollowedAtOnceByItsNextWord) {
  Machine machine;
  const std::array<core::Setting, 1> with_347{core::Setting{"347", 1}};
  ASSERT_EQ(machine.attach("display", with_347), "");
  machine.load(0100, {0200200, 0700606, 0600102});
  machine.load(0200, {0300});
  machine.load(0300, {0160000, 0200350, 0003000});
  machine.start(0100);
  machine.run({20, core::never}, recorder_);
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
  EXPECT_TRUE(machine.find<type340::Display>()->stop_interrupt(machine.now()));
}

// --- Devices ---

TEST_F(Pdp7, AbsentDevicesAnswerNothing) {
  pdp7::Options options;
  options.devices.clear();
  Machine bare(options);
  for (const std::uint32_t word : {0700001U, 0700044U, 0700101U, 0700104U, 0700201U, 0700204U, 0700301U, 0700312U, 0700401U,
                                   0700406U, 0704501U, 0707122U}) {
    bare.load(0100, {word, 0740040});
    bare.start(0100);
    EXPECT_EQ(bare.run(), StopReason::halt);
    EXPECT_EQ(bare.registers().pc, 0102U);
    EXPECT_EQ(bare.unanswered().back().word, word);
  }
}

TEST_F(Pdp7, TtsSkipsIfThereIsATeletype) {
  for (const bool teletype : {false, true}) {
    pdp7::Options options;
    if (!teletype) options.devices = {"clock", "reader", "punch"};
    Machine machine(options);
    machine.load(0100, {0703301, 0740040, 0740040});
    machine.start(0100);
    machine.run();
    EXPECT_EQ(machine.registers().pc, teletype ? 0103U : 0102U);
    EXPECT_TRUE(machine.unanswered().empty());
  }
}

// The clock is on and a line is punched: IORS shows both, CAF clears both. The disk has no bit in IORS, but CAF clears its flags.
TEST_F(Pdp7, IorsReadsAllDevicesAndCafClearsThem) {
  Machine machine;
  ASSERT_EQ(machine.attach("rb09"), "");
  machine.load(0100, {0200200, 0707144, 0700044, 0700204, 0700201, 0600104, 0700314, 0740040, 0703302, 0700314, 0740040});
  machine.load(0200, {pdp7::rb09::status::done | pdp7::rb09::status::interrupts});
  machine.start(0100);
  EXPECT_EQ(machine.run(), StopReason::halt);
  EXPECT_EQ(machine.registers().ac.value(), pdp7::status::clock_on | pdp7::status::punch);
  EXPECT_TRUE(machine.device("rb09")->interrupt_request());
  EXPECT_EQ(machine.run(), StopReason::halt);
  EXPECT_EQ(machine.registers().ac.value(), 0U);
  EXPECT_FALSE(machine.device("rb09")->interrupt_request());
  EXPECT_EQ(machine.find<pdp7::Rb09>()->status_word(), 0U);
}

// Displays AC, on device code 04, which the printer has, or on 45, which is free.
class Lamp final : public core::IotDevice {
 public:
  static constexpr std::array<std::uint8_t, 1> free_codes{045};
  static constexpr std::array<std::uint8_t, 2> taken_codes{045, 004};
  static constexpr std::array<std::uint8_t, 1> processors_codes{033};
  static constexpr core::IotDeviceInfo info{.name = "lamp", .help = "a lamp", .codes = free_codes};
  void iot(core::Instant, std::uint32_t word, core::IotReply& reply) override {
    if ((word & 04U) != 0) shown = reply.ac;
    reply.answered |= word & 04U;
  }
  core::Word18 shown;
};

TEST_F(Pdp7, AUserDefinedDeviceIsReachedByItsCode) {
  Machine machine;
  ASSERT_EQ(machine.attach(Lamp::info, std::make_unique<Lamp>()), "");
  machine.load(0100, {0760017, 0704504, 0740040});
  machine.start(0100);
  EXPECT_EQ(machine.run(), StopReason::halt);
  EXPECT_EQ(machine.find<Lamp>()->shown.value(), 0760017U);
  EXPECT_TRUE(machine.unanswered().empty());
}

TEST_F(Pdp7, ADeviceCodeTakenTwiceIsAnErrorWithBothNames) {
  Machine machine;
  core::IotDeviceInfo lamp = Lamp::info;
  lamp.codes = Lamp::taken_codes;
  EXPECT_EQ(machine.attach(lamp, std::make_unique<Lamp>()),
            "the device lamp has the device code 04, which the device printer already has");
  lamp.codes = Lamp::processors_codes;
  EXPECT_EQ(machine.attach(lamp, std::make_unique<Lamp>()),
            "the device lamp has the device code 33, which the processor already has");
  EXPECT_EQ(machine.attach(Lamp::info, nullptr), "found a null device to attach as lamp");
  EXPECT_EQ(machine.device("lamp"), nullptr);
  machine.load(0100, {0704504, 0740040});
  machine.start(0100);
  machine.run();
  EXPECT_EQ(machine.unanswered().size(), 1U);
}

// Also if the device is not connected yet.
TEST_F(Pdp7, ADeferredDeviceReservesItsCodes) {
  constexpr std::array<std::uint8_t, 1> edge{005};
  core::IotDeviceInfo lamp = Lamp::info;
  lamp.codes = edge;
  Machine machine;
  ASSERT_EQ(machine.attach_when_used("display"), "");
  EXPECT_EQ(machine.attach(lamp, std::make_unique<Lamp>()),
            "the device lamp has the device code 05, which the device display already has");
  Machine other;
  ASSERT_EQ(other.attach(lamp, std::make_unique<Lamp>()), "");
  EXPECT_EQ(other.attach_when_used("display"), "the device display has the device code 05, which the device lamp already has");
}

// A skip test requests no data break and no interrupt, but it may request the end of the run.
struct Stopper final : core::IotDevice {
  static constexpr std::array<std::uint8_t, 1> codes{045};
  static constexpr core::IotDeviceInfo info{.name = "stopper", .help = "ends the run", .codes = codes};
  explicit Stopper(Machine& of) : machine(of) {}
  void iot(core::Instant, std::uint32_t word, core::IotReply& reply) override {
    reply.answered |= word & 01U;
    machine.request_stop();
  }
  Machine& machine;
};

TEST_F(Pdp7, AStopRequestedByASkipTestTakesEffectAtTheNextBoundary) {
  for (const bool fast : {true, false}) {
    Machine machine;
    ASSERT_EQ(machine.attach(Stopper::info, std::make_unique<Stopper>(machine)), "");
    machine.load(0100, {0704501, 0600101});
    machine.start(0100);
    const pdp7::Limits limits{1000, core::never};
    EXPECT_EQ(fast ? machine.run(limits) : machine.run_plainly(limits), StopReason::observer);
    EXPECT_EQ(machine.counts().instructions, 1U);
  }
}

TEST_F(Pdp7, AnUnknownDeviceIsAnErrorWithTheNearestName) {
  Machine machine;
  std::string names;
  for (const core::IotDeviceInfo& info : pdp7::device_infos) names += (names.empty() ? "" : ", ") + std::string(info.name);
  EXPECT_EQ(machine.attach("pinter"), "found device \"pinter\", expected one of: " + names + "; did you mean \"printer\"?");
  EXPECT_EQ(machine.attach("printer"), "the device printer is already attached");
  pdp7::Options options;
  EXPECT_EQ(machine.error(), "");
  options.devices = {"clock", "drum"};
  EXPECT_EQ(Machine(options).error(), "found device \"drum\", expected one of: " + names);
}

TEST_F(Pdp7, KnownDevicesDoNotDisturbEachOther) {
  pdp7::Options options;
  options.devices.clear();
  Machine machine(options);
  for (const core::IotDeviceInfo& info : pdp7::device_infos) EXPECT_EQ(machine.attach(info.name), "");
}

TEST_F(Pdp7, AnUnknownSettingIsAnError) {
  Machine machine;
  const std::array<core::Setting, 1> unknown{core::Setting{"flash", 1}};
  EXPECT_EQ(machine.attach("display", unknown), "found option of the display \"flash\", expected one of: 342, 347, flash-again");
  const std::array<core::Setting, 2> twice{core::Setting{"347", 0}, core::Setting{"347", 1}};
  EXPECT_EQ(machine.attach("display", twice), "found the option 347 of the display twice, expected it once");
  const std::array<core::Setting, 1> large{core::Setting{"347", 2}};
  EXPECT_EQ(machine.attach_when_used("display", large), "found 2 for the option 347 of the display, expected 0 to 1");
  EXPECT_EQ(machine.device("display"), nullptr);
}

// IDLA connects a display that starts with it; the IOT of a Graphic-2 before it does not.
TEST_F(Pdp7, ADeferredDeviceIsConnectedByItsFirstIot) {
  Machine machine;
  ASSERT_EQ(machine.attach_when_used("display"), "");
  machine.load(0100, {0700547, 0740040, 0200200, 0700606, 0740000, 0600104});
  machine.load(0200, {0300});
  machine.load(0300, {0003000});
  machine.start(0100);
  EXPECT_EQ(machine.run(), StopReason::halt);
  EXPECT_EQ(machine.device("display"), nullptr);
  machine.run({100, core::never});
  ASSERT_NE(machine.device("display"), nullptr);
  EXPECT_EQ(machine.find<type340::Display>()->counters().words, 1U);
  machine.plug_in("display", true);
  EXPECT_EQ(machine.find<type340::Display>()->counters().words, 0U);
  machine.plug_in("display", false);
  EXPECT_EQ(machine.device("display"), nullptr);
}

// The taker of strokes requests a stop when a pass begins: the run ends after the IDLA.
TEST_F(Pdp7, ATakerOfStrokesStopsTheRun) {
  struct Taker final : core::StrokeTaker {
    explicit Taker(Machine& of) : machine(of) {}
    void strokes(std::span<const core::Stroke>) override {}
    void begin_pass(core::Instant) override { machine.request_stop(); }
    Machine& machine;
  };
  for (const bool plainly : {false, true}) {
    Machine machine;
    Taker taker(machine);
    ASSERT_EQ(machine.attach("display"), "");
    machine.strokes().hand_to(&taker);
    machine.load(0100, {0200200, 0700606, 0740000, 0600102});
    machine.load(0200, {0300});
    machine.start(0100);
    EXPECT_EQ(plainly ? machine.run_plainly({}) : machine.run(), StopReason::observer);
    EXPECT_EQ(machine.registers().pc, 0102U);
    machine.strokes().hand_to(nullptr);
  }
}

}  // namespace
}  // namespace sightline
