// The effect of the PDP-7's IOTs on a display, in the cases that the event files do not contain.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "emulators/type340/display.hpp"

namespace sightline::type340 {
namespace {

struct Passes final : core::StrokeTaker {
  std::vector<std::int64_t> begun;
  std::vector<std::int64_t> ended;
  std::vector<core::Stroke> flashes;
  void begin_pass(core::Instant t) override { begun.push_back(core::nanoseconds_of(t)); }
  void strokes(std::span<const core::Stroke> block) override { flashes.insert(flashes.end(), block.begin(), block.end()); }
  void end_pass(core::Instant t) override { ended.push_back(core::nanoseconds_of(t)); }
};

using core::at_nanoseconds;
using core::Word18;

class DisplayControl : public ::testing::Test {
 protected:
  // Starts at `address` at t and gives the words without waiting. Returns the instant of the request after the last word, or
  // 10 ns after the last word if there is no request.
  std::int64_t play(std::int64_t t, std::uint32_t address, const std::vector<std::uint32_t>& words) {
    display_.load_address_and_start(at_nanoseconds(t), Word18(address));
    for (const std::uint32_t word : words) {
      EXPECT_NE(display_.data_break(), nullptr);
      display_.end_break(at_nanoseconds(t), Word18(word));
      for (const std::int64_t end = t + 400'000; t < end && display_.data_break() == nullptr; t += 100) {
        display_.advance(at_nanoseconds(t + 100));
      }
    }
    return t;
  }

  DisplayControl() { strokes_.hand_to(&passes_); }
  std::size_t flashes() {
    strokes_.flush();
    return passes_.flashes.size();
  }

  Passes passes_;
  core::StrokeBuffer strokes_;
  Display display_{{}, strokes_};
};

// LAW buf; IDLA leaves AC = 76xxxx: only 13 bits count, and the counter wraps inside them.
TEST_F(DisplayControl, AddressHasThirteenBits) {
  const std::int64_t t = play(0, 0777777, {0});
  EXPECT_EQ(display_.data_break()->address, 0);
  EXPECT_EQ(display_.address_counter(at_nanoseconds(t)), Word18(0));
  play(t, 0761234, {});
  EXPECT_EQ(display_.data_break()->address, 01234);
}

TEST_F(DisplayControl, CoordinatesAreHalvedAndPacked) {
  const std::int64_t t = play(0, 0, {020000, 0221777, 020003});
  EXPECT_EQ(display_.coordinates(at_nanoseconds(t)), Word18(0001777));
}

TEST_F(DisplayControl, IdleDisplayHasNoDeadline) {
  EXPECT_EQ(display_.deadline(), core::never);
  display_.advance(at_nanoseconds(1'000'000));
  EXPECT_EQ(display_.data_break(), nullptr);
  EXPECT_FALSE(display_.interrupt_request());
}

// A word that comes when none was asked for is dropped.
TEST_F(DisplayControl, UnaskedWordIsIgnored) {
  display_.end_break(at_nanoseconds(0), Word18(0003000));
  EXPECT_EQ(display_.deadline(), core::never);
  EXPECT_EQ(display_.counters().words, 0U);
}

TEST_F(DisplayControl, ClearFlagsDropsAWaitingRequestAndTheStop) {
  std::int64_t t = play(0, 0, {0});
  display_.clear_flags(at_nanoseconds(t));
  EXPECT_EQ(display_.data_break(), nullptr);
  EXPECT_EQ(display_.deadline(), core::never);
  t = play(t, 0, {0003000});
  EXPECT_TRUE(display_.stop_interrupt(at_nanoseconds(t)));
  EXPECT_TRUE(display_.interrupt_request());
  display_.clear_flags(at_nanoseconds(t));
  EXPECT_FALSE(display_.stop_interrupt(at_nanoseconds(t)));
  EXPECT_FALSE(display_.interrupt_request());
}

TEST_F(DisplayControl, ClearFlagsLeavesTheRunningWordAlone) {
  const std::int64_t t = play(0, 0, {0100117});
  display_.end_break(at_nanoseconds(t), Word18(0200177));
  display_.clear_flags(at_nanoseconds(t + 50'000));
  display_.advance(at_nanoseconds(t + 193'799));
  EXPECT_EQ(display_.data_break(), nullptr);
  display_.advance(at_nanoseconds(t + 193'800));
  ASSERT_NE(display_.data_break(), nullptr);
  EXPECT_EQ(display_.requested_at(), at_nanoseconds(t + 193'800));
}

// The running word ends where it is; scale, intensity and position stay.
TEST_F(DisplayControl, StartWhileRunningAbandonsTheWord) {
  const std::int64_t t = play(0, 0, {0100137});
  display_.end_break(at_nanoseconds(t), Word18(0200177));
  display_.load_address_and_start(at_nanoseconds(t + 10'000), Word18(0100));
  ASSERT_NE(display_.data_break(), nullptr);
  EXPECT_EQ(display_.requested_at(), at_nanoseconds(t + 10'000));
  EXPECT_EQ(display_.data_break()->address, 0100);
  // Pulses at 3.3 us after the word and every 1.5 us: five of them, two points each.
  EXPECT_EQ(display_.registers().x, 10);
  const std::size_t before = flashes();
  display_.advance(at_nanoseconds(t + 400'000));
  EXPECT_EQ(flashes(), before);
  EXPECT_EQ(display_.registers().mode, Mode::parameter);
  EXPECT_EQ(display_.registers().scale, 1);
  EXPECT_EQ(display_.registers().intensity, 7);
}

TEST_F(DisplayControl, RestartContinuesFromTheCounter) {
  const std::int64_t t = play(0, 0100, {0, 0003000});
  display_.restart(at_nanoseconds(t));
  ASSERT_NE(display_.data_break(), nullptr);
  EXPECT_EQ(display_.data_break()->address, 0102);
  EXPECT_FALSE(display_.stop_interrupt(at_nanoseconds(t)));
}

TEST_F(DisplayControl, PowerClearStopsEverything) {
  const std::int64_t t = play(0, 0, {020000, 0020123, 0220321});
  display_.power_clear(at_nanoseconds(t));
  EXPECT_EQ(display_.data_break(), nullptr);
  EXPECT_EQ(display_.deadline(), core::never);
  EXPECT_EQ(display_.registers().x, 0123);
  EXPECT_EQ(display_.registers().y, 0321);
}

// A stop word that names mode 1: IDRS executes the buffer again, now as a point word, and the display continues.
TEST_F(DisplayControl, ResumeAfterAStopExecutesTheBufferAgain) {
  const std::int64_t t = play(0, 0, {0023000});
  ASSERT_EQ(display_.data_break(), nullptr);
  display_.resume(at_nanoseconds(t));
  display_.advance(at_nanoseconds(t + 1000 + 500 + 35'500 - 1));
  EXPECT_EQ(display_.data_break(), nullptr);
  display_.advance(at_nanoseconds(t + 1000 + 500 + 35'500));
  EXPECT_NE(display_.data_break(), nullptr);
}

// For 1 us the edge flag of a vector continue is seen by the skips and the interrupt line.
TEST_F(DisplayControl, VectorContinueShowsItsEdgeForOneMicrosecond) {
  const std::int64_t t = play(0, 0, {0120117});
  display_.end_break(at_nanoseconds(t), Word18(0200377));
  EXPECT_EQ(display_.deadline(), at_nanoseconds(t + 3300));
  EXPECT_TRUE(display_.horizontal_edge(at_nanoseconds(t + 3300)));
  EXPECT_FALSE(display_.vertical_edge(at_nanoseconds(t + 3300)));
  EXPECT_TRUE(display_.interrupt_request());
  EXPECT_EQ(display_.deadline(), at_nanoseconds(t + 4300));
  EXPECT_FALSE(display_.horizontal_edge(at_nanoseconds(t + 4300)));
  EXPECT_FALSE(display_.interrupt_request());
}

TEST_F(DisplayControl, PassesAreCountedAndTimed) {
  play(0, 0, {0003000});
  const std::int64_t second = 500'000;
  play(second, 0, {0100117, 0377400});  // off the bottom
  EXPECT_EQ(passes_.begun, (std::vector<std::int64_t>{0, second}));
  EXPECT_EQ(passes_.ended, (std::vector<std::int64_t>{3300, second + 3300 + 3300 + 1000}));
  const Counters& counters = display_.counters();
  EXPECT_EQ(counters.words, 3U);
  EXPECT_EQ(counters.passes_started, 2U);
  EXPECT_EQ(counters.passes_stopped, 2U);
  EXPECT_EQ(counters.last_start, at_nanoseconds(second));
  EXPECT_EQ(counters.previous_start, at_nanoseconds(0));
}

TEST_F(DisplayControl, StrokesCarryTheAddressOfTheirWord) {
  play(0, 0200, {0100112, 0600003});
  ASSERT_NE(flashes(), 0U);
  EXPECT_EQ(passes_.flashes[0].address, 0201);
  EXPECT_EQ(passes_.flashes[0].intensity, 2);
}

}  // namespace
}  // namespace sightline::type340
