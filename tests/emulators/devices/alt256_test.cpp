// The ALT-256 board: one dot a scan line of 63.5 us = 190.5 T-states at 3 MHz. Blanking n begins at 52.6
// + 63.5 n us: T-states 157.8, 348.3, 538.8, ..., so the first whole T-state in it is 158, 349, 539.
#include "emulators/devices/alt256.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>

#include "tests/emulators/devices/device_test.hpp"

namespace {

using sightline::core::at_t_state;
using sightline::devices::Alt256;
using sightline::tests::three_megahertz;

constexpr std::uint8_t data = 0;
constexpr std::uint8_t x = 1;
constexpr std::uint8_t y = 2;
constexpr std::uint8_t erase = 3;

TEST(Alt256, HandshakeOfTwoDots) {
  const auto board = std::make_unique<Alt256>(three_megahertz);
  const auto status = [&](std::int64_t t) { return int{board->read_status(at_t_state(t))}; };
  EXPECT_EQ(status(0), 0x80);
  board->write(x, 17, at_t_state(10));
  board->write(y, 200, at_t_state(20));
  board->write(data, 5, at_t_state(30));
  EXPECT_EQ(status(31), 0x00);
  EXPECT_EQ(status(157), 0x00);
  EXPECT_EQ(status(158), 0xC0);
  EXPECT_EQ(status(190), 0xC0);
  EXPECT_EQ(status(191), 0x80);  // the next line
  EXPECT_EQ(board->raster()->at(17, 200), 5);
  board->write(x, 18, at_t_state(200));
  board->write(data, 6, at_t_state(349));  // already in blanking: waits for the next one
  EXPECT_EQ(status(350), 0x40);
  EXPECT_EQ(status(538), 0x00);
  EXPECT_EQ(status(539), 0xC0);
  EXPECT_EQ(board->raster()->at(18, 200), 6);
  EXPECT_EQ(board->totals().dots, 2U);
  EXPECT_EQ(board->totals().writes_lost, 0U);
}

TEST(Alt256, WritesWhileNotReadyAreLost) {
  const auto board = std::make_unique<Alt256>(three_megahertz);
  board->write(data, 7, at_t_state(0));
  board->write(x, 1, at_t_state(100));
  board->write(data, 3, at_t_state(110));
  board->write(erase, 0, at_t_state(157));
  EXPECT_EQ(board->totals().writes_lost, 3U);
  EXPECT_EQ(board->raster()->at(0, 0), 7);
  board->write(data, 3, at_t_state(158));
  EXPECT_EQ(board->raster()->at(0, 0), 3);
  EXPECT_EQ(board->raster()->at(1, 0), 0);
}

TEST(Alt256, ADotTakesNoTimeBeyondTheNanosecondRange) {
  const auto board = std::make_unique<Alt256>(sightline::core::ClockRate{1});
  constexpr std::int64_t late = 9'300'000'000;
  board->write(data, 7, at_t_state(late));
  EXPECT_TRUE(board->ready(at_t_state(late)));
  EXPECT_GE(sightline::core::t_states_of(board->ready_at()), 0);
  EXPECT_EQ(board->raster()->at(0, 0), 7);
}

TEST(Alt256, EraseTakesTwoFields) {
  const auto board = std::make_unique<Alt256>(three_megahertz);
  board->write(erase, 0xFA, at_t_state(1000));
  EXPECT_EQ(board->raster()->at(255, 255), 2);
  EXPECT_EQ(board->ready_at(), at_t_state(1000 + 99'900));
  EXPECT_EQ(board->totals().erases, 1U);
}

TEST(Alt256, TwentyThousandDotsTakeTwentyThousandLines) {
  const auto board = std::make_unique<Alt256>(three_megahertz);
  sightline::core::TStateInstant now{};
  for (int n = 0; n < 20'000; ++n) {
    board->write(data, 1, now);
    now = board->ready_at();
  }
  // 157.8 + 19,999 times 190.5: 1.27 s whatever the speed of the processor.
  EXPECT_EQ(now, at_t_state(3'809'968));
  EXPECT_EQ(board->totals().writes_lost, 0U);
}

TEST(Alt256, RowsBeyondTheFrameAreCountedAndYCanCountDown) {
  const auto up = std::make_unique<Alt256>(three_megahertz);
  up->write(y, 240, at_t_state(0));
  up->write(data, 1, at_t_state(0));
  EXPECT_EQ(up->totals().dots_invisible, 1U);
  const auto down = std::make_unique<Alt256>(three_megahertz, true);
  down->write(y, 240, at_t_state(0));
  down->write(data, 1, at_t_state(0));
  EXPECT_EQ(down->totals().dots_invisible, 0U);
  EXPECT_EQ(down->raster()->at(0, 15), 1);
}

}  // namespace
