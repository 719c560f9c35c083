// Each device by itself: every IOT pulse, when its flag rises, what it puts on the bus.
#include "emulators/pdp7/peripherals.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "emulators/pdp7/console.hpp"
#include "emulators/pdp7/core_memory.hpp"

namespace sightline {
namespace {

using core::at_nanoseconds;

class Pdp7Peripherals : public testing::Test {
 protected:
  // AC after the IOT at `ns`; bit 14 clears AC in the processor, so the tests pass what it would.
  std::uint32_t iot(std::int64_t ns, std::uint32_t word, std::uint32_t ac = 0) {
    last_ = devices_.iot(at_nanoseconds(ns), word, core::Word18(ac), 0);
    return last_.ac.value();
  }
  bool skips(std::int64_t ns, std::uint32_t word) {
    iot(ns, word);
    EXPECT_EQ(last_.answered, 1U) << std::oct << word;
    return last_.skip;
  }

  pdp7::Timing timing_;
  pdp7::Peripherals devices_{{}, timing_};
  pdp7::IotReply last_;
};

constexpr std::int64_t line = 3'333'333;

TEST_F(Pdp7Peripherals, ReaderReadsALineOfEightHoles) {
  devices_.reader.load({0377, 0012});
  EXPECT_FALSE(skips(0, 0700101));
  iot(1000, 0700104);
  EXPECT_EQ(devices_.deadline(), at_nanoseconds(1000 + line));
  EXPECT_FALSE(skips(1000 + line - 1, 0700101));
  EXPECT_TRUE(skips(1000 + line, 0700101));
  EXPECT_TRUE(devices_.interrupt_request());
  EXPECT_EQ(iot(1000 + line, 0700314), pdp7::status::reader);
  EXPECT_EQ(iot(1000 + line, 0700102, 0400000), 0400377U);
  EXPECT_FALSE(skips(1000 + line, 0700101));
  iot(5'000'000, 0700104);
  EXPECT_TRUE(skips(5'000'000 + line, 0700101));
  EXPECT_EQ(iot(9'000'000, 0700112), 0012U);
}

TEST_F(Pdp7Peripherals, ReaderAssemblesThreeLinesAndPassesOverThoseWithoutHoleEight) {
  devices_.reader.load({0, 0, 0212, 0077, 0234, 0256, 0201, 0202, 0203});
  iot(0, 0700144);
  EXPECT_EQ(devices_.reader.deadline(), at_nanoseconds(6 * line));
  EXPECT_TRUE(skips(6 * line, 0700101));
  EXPECT_EQ(iot(6 * line, 0700112), 0123456U);
  iot(6 * line, 0700144);
  EXPECT_EQ(iot(9 * line, 0700112), 0010203U);
}

TEST_F(Pdp7Peripherals, ReaderOutOfTapeNeverRaisesItsFlag) {
  devices_.reader.load({0201, 0202});
  iot(0, 0700144);
  EXPECT_EQ(devices_.deadline(), core::never);
  EXPECT_TRUE(devices_.reader.out_of_tape());
  EXPECT_FALSE(skips(1'000'000'000, 0700101));
}

TEST_F(Pdp7Peripherals, ANewRequestLeavesTheTapeWhereItHadComeTo) {
  devices_.reader.load({0201, 0202, 0203, 0204, 0205, 0206});
  iot(0, 0700144);
  iot(line + 10, 0700144);
  EXPECT_EQ(iot(line + 10 + 3 * line, 0700112), 0020304U);
}

TEST_F(Pdp7Peripherals, PunchPunchesEightBitsOrSixWithHoleEight) {
  constexpr std::int64_t punch = 15'797'788;
  iot(0, 0700204, 0123456);
  EXPECT_FALSE(skips(punch - 1, 0700201));
  EXPECT_TRUE(devices_.punch.tape().empty());
  EXPECT_TRUE(skips(punch, 0700201));
  iot(punch, 0700202);
  EXPECT_FALSE(skips(punch, 0700201));
  iot(punch, 0700244, 0123456);
  EXPECT_TRUE(skips(2 * punch, 0700201));
  iot(2 * punch, 0700206, 0000012);
  EXPECT_FALSE(skips(2 * punch, 0700201));
  EXPECT_TRUE(skips(3 * punch, 0700201));
  EXPECT_EQ(devices_.punch.tape(), (std::vector<std::uint8_t>{0056, 0256, 0012}));
}

TEST_F(Pdp7Peripherals, KeyboardMarksChannelEightAndSendsTenCharactersASecond) {
  devices_.keyboard.press(at_nanoseconds(0), 'A');
  devices_.keyboard.press(at_nanoseconds(0), 'B');
  EXPECT_FALSE(skips(99'999'999, 0700301));
  EXPECT_TRUE(skips(100'000'000, 0700301));
  EXPECT_EQ(iot(100'000'000, 0700314), pdp7::status::keyboard);
  EXPECT_EQ(iot(100'000'000, 0700312), 0301U);
  EXPECT_FALSE(skips(199'999'999, 0700301));
  EXPECT_EQ(iot(200'000'000, 0700312), 0302U);
}

TEST_F(Pdp7Peripherals, AProgramThatHasReadItsKeyAsksForNone) {
  EXPECT_FALSE(skips(0, 0700301));
  EXPECT_TRUE(devices_.keyboard.asked());
  devices_.keyboard.press(at_nanoseconds(0), 'A');
  EXPECT_FALSE(devices_.keyboard.asked());
  EXPECT_FALSE(skips(50'000'000, 0700301));
  EXPECT_TRUE(devices_.keyboard.asked());
  EXPECT_TRUE(skips(100'000'000, 0700301));
  EXPECT_EQ(iot(100'000'000, 0700312), 0301U);
  EXPECT_FALSE(devices_.keyboard.asked());
  EXPECT_FALSE(skips(100'000'001, 0700301));
  EXPECT_TRUE(devices_.keyboard.asked());
}

TEST_F(Pdp7Peripherals, PrinterRaisesItsFlagACharacterTimeLater) {
  iot(0, 0700406, 0301);
  EXPECT_FALSE(skips(99'999'999, 0700401));
  EXPECT_TRUE(skips(100'000'000, 0700401));
  EXPECT_EQ(iot(100'000'000, 0700314), pdp7::status::printer);
  iot(100'000'000, 0700402);
  EXPECT_FALSE(skips(100'000'000, 0700401));
  EXPECT_EQ(devices_.printer.printed(), (std::vector<std::uint8_t>{0301}));
}

TEST_F(Pdp7Peripherals, ClockTicksFiftyTimesASecondInStepWithTheMains) {
  iot(5'000'000, 0700044);
  EXPECT_EQ(iot(5'000'000, 0700314), pdp7::status::clock_on);
  EXPECT_EQ(devices_.deadline(), at_nanoseconds(20'000'000));
  EXPECT_FALSE(devices_.clock.take_tick(at_nanoseconds(19'999'999)));
  EXPECT_TRUE(devices_.clock.take_tick(at_nanoseconds(20'000'000)));
  EXPECT_FALSE(devices_.clock.take_tick(at_nanoseconds(20'000'000)));
  devices_.clock.raise_flag();
  EXPECT_TRUE(skips(20'000'001, 0700001));
  iot(20'000'002, 0700004);
  EXPECT_FALSE(skips(20'000'002, 0700001));
  EXPECT_EQ(devices_.deadline(), core::never);
}

TEST(Pdp7Clock, SixtyHertzDoesNotDrift) {
  pdp7::Clock clock(60);
  clock.turn_on(at_nanoseconds(0));
  for (int i = 0; i < 59; ++i) EXPECT_TRUE(clock.take_tick(clock.deadline()));
  EXPECT_EQ(clock.deadline(), at_nanoseconds(1'000'000'000));
}

TEST_F(Pdp7Peripherals, CafPutsEveryFlagDownAndTheClockOff) {
  devices_.reader.load({0201});
  iot(0, 0700104);
  iot(0, 0700204, 1);
  iot(0, 0700406, 1);
  iot(0, 0700044);
  devices_.keyboard.press(at_nanoseconds(0), 'A');
  devices_.clock.raise_flag();
  EXPECT_NE(iot(100'000'000, 0700314), 0U);
  iot(100'000'000, 0703302);
  EXPECT_EQ(last_.answered, 2U);
  EXPECT_EQ(iot(100'000'000, 0700314), 0U);
  EXPECT_FALSE(devices_.interrupt_request());
}

TEST_F(Pdp7Peripherals, AbsentDevicesAnswerNothing) {
  const pdp7::Devices none{false, false, false, false};
  pdp7::Peripherals bare(none, timing_);
  for (const std::uint32_t word : {0700001U, 0700044U, 0700101U, 0700104U, 0700201U, 0700204U, 0700301U,
                                   0700312U, 0700401U, 0700406U, 0704501U, 0703341U}) {
    const pdp7::IotReply reply = bare.iot(at_nanoseconds(0), word, core::Word18(0), 0);
    EXPECT_EQ(reply.answered, 0U) << std::oct << word;
    EXPECT_FALSE(reply.skip);
  }
  EXPECT_EQ(bare.deadline(), core::never);
  EXPECT_EQ(bare.iot(at_nanoseconds(0), 0703301, core::Word18(0), 0).skip, false);
}

TEST_F(Pdp7Peripherals, TtsSkipsWithATeletype) {
  EXPECT_TRUE(skips(0, 0703301));
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
