// Each device alone: every IOT pulse, when its flag rises, what it puts on the bus.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "emulators/pdp7/clock.hpp"
#include "emulators/pdp7/console.hpp"
#include "emulators/pdp7/core_memory.hpp"
#include "emulators/pdp7/paper_tape.hpp"
#include "emulators/pdp7/status.hpp"
#include "emulators/pdp7/teletype.hpp"
#include "emulators/pdp7/timing.hpp"

namespace sightline {
namespace {

using core::at_nanoseconds;

class Pdp7Peripherals : public testing::Test {
 protected:
  // AC after the IOT at `ns`. Bit 14 clears AC in the processor, so the tests pass the cleared value.
  std::uint32_t iot(std::int64_t ns, std::uint32_t word, std::uint32_t ac = 0) {
    last_ = {core::Word18(ac)};
    all_.at((word >> 6) & 077U)->iot(at_nanoseconds(ns), word, last_);
    return last_.ac.value();
  }
  bool skips(std::int64_t ns, std::uint32_t word) {
    iot(ns, word);
    EXPECT_EQ(last_.answered, 1U) << std::oct << word;
    return last_.skip;
  }
  // The combined IORS answer of all devices.
  std::uint32_t status(std::int64_t ns) {
    std::uint32_t bits = 0;
    for (core::IotDevice* const each : all_) bits |= each->status(at_nanoseconds(ns));
    return bits;
  }
  [[nodiscard]] core::Instant deadline() const {
    core::Instant least = core::never;
    for (const core::IotDevice* const each : all_) least = std::min(least, each->deadline());
    return least;
  }
  [[nodiscard]] bool interrupt_request() const {
    return std::any_of(all_.begin(), all_.end(), [](const core::IotDevice* each) { return each->interrupt_request(); });
  }
  // True if a tick is due; then gives it its cycle.
  bool tick(std::int64_t ns, std::uint32_t count = 1) {
    clock_.advance(at_nanoseconds(ns));
    const core::DataBreak* const request = clock_.data_break();
    if (request == nullptr) return false;
    EXPECT_EQ(request->direction, core::DataBreak::Direction::count);
    EXPECT_EQ(request->address, 7U);
    EXPECT_EQ(request->cycles, timing_.clock_tick_cycles);
    clock_.end_break(at_nanoseconds(ns + 1750), core::Word18(count));
    return true;
  }

  pdp7::Timing timing_;
  pdp7::Clock clock_{timing_.clock_hertz, timing_.clock_tick_cycles};
  pdp7::Reader reader_{timing_.reader_line};
  pdp7::Punch punch_{timing_.punch_line};
  pdp7::Keyboard keyboard_{timing_.teletype_character};
  pdp7::Printer printer_{timing_.teletype_character};
  std::array<core::IotDevice*, 5> all_{&clock_, &reader_, &punch_, &keyboard_, &printer_};  // in order of their codes
  core::IotReply last_;
};

constexpr std::int64_t line = 3'333'333;

TEST_F(Pdp7Peripherals, ReaderReadsALineOfEightHoles) {
  reader_.load({0377, 0012});
  EXPECT_FALSE(skips(0, 0700101));
  iot(1000, 0700104);
  EXPECT_EQ(deadline(), at_nanoseconds(1000 + line));
  EXPECT_FALSE(skips(1000 + line - 1, 0700101));
  EXPECT_TRUE(skips(1000 + line, 0700101));
  EXPECT_TRUE(interrupt_request());
  EXPECT_EQ(status(1000 + line), pdp7::status::reader);
  EXPECT_EQ(iot(1000 + line, 0700102, 0400000), 0400377U);
  EXPECT_FALSE(skips(1000 + line, 0700101));
  iot(5'000'000, 0700104);
  EXPECT_TRUE(skips(5'000'000 + line, 0700101));
  EXPECT_EQ(iot(9'000'000, 0700112), 0012U);
}

TEST_F(Pdp7Peripherals, ReaderAssemblesThreeLinesAndSkipsThoseWithoutHoleEight) {
  reader_.load({0, 0, 0212, 0077, 0234, 0256, 0201, 0202, 0203});
  iot(0, 0700144);
  EXPECT_EQ(reader_.deadline(), at_nanoseconds(6 * line));
  EXPECT_TRUE(skips(6 * line, 0700101));
  EXPECT_EQ(iot(6 * line, 0700112), 0123456U);
  iot(6 * line, 0700144);
  EXPECT_EQ(iot(9 * line, 0700112), 0010203U);
}

TEST_F(Pdp7Peripherals, ReaderOutOfTapeNeverRaisesItsFlag) {
  reader_.load({0201, 0202});
  iot(0, 0700144);
  EXPECT_EQ(deadline(), core::never);
  EXPECT_TRUE(reader_.out_of_tape());
  EXPECT_FALSE(skips(1'000'000'000, 0700101));
}

TEST_F(Pdp7Peripherals, ANewRequestDoesNotMoveTheTape) {
  reader_.load({0201, 0202, 0203, 0204, 0205, 0206});
  iot(0, 0700144);
  iot(line + 10, 0700144);
  EXPECT_EQ(iot(line + 10 + 3 * line, 0700112), 0020304U);
}

TEST_F(Pdp7Peripherals, PunchPunchesEightBitsOrSixWithHoleEight) {
  constexpr std::int64_t punch = 15'797'788;
  iot(0, 0700204, 0123456);
  EXPECT_FALSE(skips(punch - 1, 0700201));
  EXPECT_TRUE(punch_.tape().empty());
  EXPECT_TRUE(skips(punch, 0700201));
  iot(punch, 0700202);
  EXPECT_FALSE(skips(punch, 0700201));
  iot(punch, 0700244, 0123456);
  EXPECT_TRUE(skips(2 * punch, 0700201));
  iot(2 * punch, 0700206, 0000012);
  EXPECT_FALSE(skips(2 * punch, 0700201));
  EXPECT_TRUE(skips(3 * punch, 0700201));
  EXPECT_EQ(punch_.tape(), (std::vector<std::uint8_t>{0056, 0256, 0012}));
}

TEST_F(Pdp7Peripherals, KeyboardMarksChannelEightAndSendsTenCharactersASecond) {
  keyboard_.press(at_nanoseconds(0), 'A');
  keyboard_.press(at_nanoseconds(0), 'B');
  EXPECT_FALSE(skips(99'999'999, 0700301));
  EXPECT_TRUE(skips(100'000'000, 0700301));
  EXPECT_EQ(status(100'000'000), pdp7::status::keyboard);
  EXPECT_EQ(iot(100'000'000, 0700312), 0301U);
  EXPECT_FALSE(skips(199'999'999, 0700301));
  EXPECT_EQ(iot(200'000'000, 0700312), 0302U);
}

TEST_F(Pdp7Peripherals, WaitingForAKeyEndsWhenTheProgramReadsIt) {
  EXPECT_FALSE(skips(0, 0700301));
  EXPECT_TRUE(keyboard_.polled());
  keyboard_.press(at_nanoseconds(0), 'A');
  EXPECT_FALSE(keyboard_.polled());
  EXPECT_FALSE(skips(50'000'000, 0700301));
  EXPECT_TRUE(keyboard_.polled());
  EXPECT_TRUE(skips(100'000'000, 0700301));
  EXPECT_EQ(iot(100'000'000, 0700312), 0301U);
  EXPECT_FALSE(keyboard_.polled());
  EXPECT_FALSE(skips(100'000'001, 0700301));
  EXPECT_TRUE(keyboard_.polled());
}

TEST_F(Pdp7Peripherals, PrinterRaisesItsFlagACharacterTimeLater) {
  iot(0, 0700406, 0301);
  EXPECT_FALSE(skips(99'999'999, 0700401));
  EXPECT_TRUE(skips(100'000'000, 0700401));
  EXPECT_EQ(status(100'000'000), pdp7::status::printer);
  iot(100'000'000, 0700402);
  EXPECT_FALSE(skips(100'000'000, 0700401));
  EXPECT_EQ(printer_.printed(), (std::vector<std::uint8_t>{0301}));
}

TEST_F(Pdp7Peripherals, ClockTicksFiftyTimesASecondInStepWithTheMains) {
  iot(5'000'000, 0700044);
  EXPECT_EQ(status(5'000'000), pdp7::status::clock_on);
  EXPECT_EQ(deadline(), at_nanoseconds(20'000'000));
  EXPECT_FALSE(tick(19'999'999));
  EXPECT_TRUE(tick(20'000'000));
  EXPECT_FALSE(tick(20'000'000));
  EXPECT_FALSE(skips(20'000'000, 0700001));
  EXPECT_TRUE(tick(40'000'000, 0));
  EXPECT_TRUE(skips(40'000'001, 0700001));
  iot(40'000'002, 0700004);
  EXPECT_FALSE(skips(40'000'002, 0700001));
  EXPECT_EQ(deadline(), core::never);
}

TEST(Pdp7Clock, SixtyHertzDoesNotDrift) {
  pdp7::Clock clock(60);
  core::IotReply reply;
  clock.iot(at_nanoseconds(0), 0700044, reply);
  for (int i = 0; i < 59; ++i) {
    clock.advance(clock.deadline());
    ASSERT_NE(clock.data_break(), nullptr);
    clock.end_break(clock.deadline(), core::Word18(1));
  }
  EXPECT_EQ(clock.deadline(), at_nanoseconds(1'000'000'000));
}

TEST_F(Pdp7Peripherals, CafClearsEveryFlagAndTurnsTheClockOff) {
  reader_.load({0201});
  iot(0, 0700104);
  iot(0, 0700204, 1);
  iot(0, 0700406, 1);
  iot(0, 0700044);
  keyboard_.press(at_nanoseconds(0), 'A');
  EXPECT_TRUE(tick(20'000'000, 0));
  EXPECT_NE(status(100'000'000), 0U);
  for (core::IotDevice* const each : all_) each->clear_flags(at_nanoseconds(100'000'000));
  EXPECT_EQ(status(100'000'000), 0U);
  EXPECT_FALSE(interrupt_request());
}

TEST(Pdp7Console, SwitchesFollowTheirSchedule) {
  pdp7::Console console;
  console.set(core::Word18(1));
  console.schedule({{at_nanoseconds(200), core::Word18(3)}, {at_nanoseconds(100), core::Word18(2)}});
  EXPECT_EQ(console.switches(at_nanoseconds(99)).value(), 1U);
  EXPECT_EQ(console.switches(at_nanoseconds(100)).value(), 2U);
  EXPECT_EQ(console.switches(at_nanoseconds(1000)).value(), 3U);
}

TEST(Pdp7CoreMemory, OutsideCoreReadsZeroAndIgnoresWrites) {
  for (const std::uint32_t words : {4096U, 8192U, 16384U, 32768U}) {
    pdp7::CoreMemory memory(words);
    memory.randomise(1);
    memory.write(words - 1, core::Word18(0123456));
    EXPECT_EQ(memory.read(words - 1).value(), 0123456U);
    if (words == 32768) continue;
    memory.write(words, core::Word18(0123456));
    EXPECT_EQ(memory.read(words).value(), 0U);
    EXPECT_EQ(memory.read(077777).value(), 0U);
  }
}

TEST(Pdp7CoreMemory, TwoSeedsFillCoreDifferentlyAndOneTheSame) {
  pdp7::CoreMemory a(4096);
  pdp7::CoreMemory b(4096);
  pdp7::CoreMemory c(4096);
  a.randomise(1);
  b.randomise(1);
  c.randomise(2);
  int different = 0;
  for (pdp7::Address i = 0; i < 4096; ++i) {
    ASSERT_EQ(a.read(i), b.read(i));
    different += a.read(i) != c.read(i) ? 1 : 0;
  }
  EXPECT_GT(different, 4000);
}

}  // namespace
}  // namespace sightline
