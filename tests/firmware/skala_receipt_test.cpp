// The resident Skala program's monitor: rejected commands, both links, a picture larger than its buffer, failing devices.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "tests/firmware/skala_machine.hpp"
#include "tests/firmware/skala_reference.hpp"
#include "tests/support/effort.hpp"

namespace sightline::skala_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::optional<std::uint8_t> status_of(Bytes commands) {
  SkalaMachine machine(std::move(commands));
  return machine.run();
}

TEST(SkalaReceipt, StopsAtAnUnknownCommand) {
  for (const int code : {0x0F, 0x10, 0x80, 0xFF})
    EXPECT_EQ(status_of({static_cast<std::uint8_t>(code)}), 2) << code;
  EXPECT_EQ(status_of({1, 5, 5, 2, 9, 9, 0x0F}), 2);
}

TEST(SkalaReceipt, StopsAtTheOffendingArgument) {
  EXPECT_EQ(status_of({8, 200, 57}), 3);
  EXPECT_EQ(status_of({8, 1, 0}), 3);
  EXPECT_EQ(status_of({14, 255, 2}), 3);
  EXPECT_EQ(status_of({14, 255, 0}), 3);
  EXPECT_EQ(status_of({10, 4}), 3);
  EXPECT_EQ(status_of({10, 0x84}), 3);
  EXPECT_EQ(status_of({14, 255, 1, 14, 0, 0, 14, 200, 56, 10, 0x80, 0}), 1);
}

TEST(SkalaReceipt, DrawsNothingOfARefusedPicture) {
  SkalaMachine machine({1, 10, 10, 2, 90, 90, 15});
  ASSERT_EQ(machine.run(), 2);
  EXPECT_EQ(machine.ef9365().totals().dots, 0U);
}

TEST(SkalaReceipt, WaitsForMore) {
  SkalaMachine machine({1, 10, 10, 2, 90});
  i8080::Limits limits;
  limits.until = core::at_t_state(10'000'000);
  EXPECT_EQ(machine.machine().run(limits), i8080::StopReason::time_limit);
  EXPECT_EQ(machine.machine().peek(label("STATUS")), 0);
}

TEST(SkalaReceipt, APictureMayBeLargerThanTheBuffer) {
  NEEDS_OPTIMISED_CODE();
  Bytes commands{10, 0};
  for (int i = 0; i < 40'000; ++i) {
    const auto x = static_cast<std::uint8_t>(i % 256);
    const auto y = static_cast<std::uint8_t>(20 + i * 7 / 1000 + (i * i % 5));
    commands.insert(commands.end(), {static_cast<std::uint8_t>(x == 0 ? 1 : 2), x, y});
    if (x == 255) commands.push_back(6);
  }
  commands.push_back(0);
  Reference reference;
  reference.run(commands);
  SkalaMachine machine(commands);
  ASSERT_EQ(machine.run(), 1);
  const auto points = machine.ef9365().raster()->points();
  EXPECT_TRUE(std::equal(points.begin(), points.end(), reference.picture.begin()));
}

TEST(SkalaReceipt, OverTheSerialLink) {
  SkalaMachine machine({1, 10, 10, 2, 20, 10, 0}, {{"ef9365"}, {"serial"}});
  machine.machine().deposit(label("LINKSW"), 1);
  ASSERT_EQ(machine.run(), 1);
  EXPECT_EQ(machine.ef9365().totals().dots, 11U);
}

// The host sends at half the speed: the stop bit is not where it should be.
TEST(SkalaReceipt, StopsAtALineError) {
  SkalaMachine machine({1, 10, 10, 2, 20, 10, 0}, {{"ef9365"}, {"serial", {{"baud", 4800}}}});
  machine.machine().deposit(label("LINKSW"), 1);
  EXPECT_EQ(machine.run(), 4);
}

TEST(SkalaDevices, MustAnswer) {
  const std::vector<Attachment> only_the_link{{"parallel"}};
  for (const int device : {0, 1, 2}) {
    SkalaMachine machine({10, static_cast<std::uint8_t>(device), 0}, only_the_link);
    EXPECT_EQ(machine.run(), 6) << device;
  }
  SkalaMachine minigraf({10, 3, 0}, only_the_link);
  EXPECT_EQ(minigraf.run(), 1);
}

// The carriage is at its end: a step beyond it is a plotter error.
TEST(SkalaDevices, APlotterErrorStopsTheProgram) {
  SkalaMachine machine({10, 2, 1, 200, 200, 2, 250, 250, 0},
                       {{"ef9365"}, {"alt256"}, {"calcomp565", {{"start-y", 1100}}}, {"minigraf0507"}, {"parallel"}});
  EXPECT_EQ(machine.run(), 5);
}

}  // namespace
}  // namespace sightline::skala_test
