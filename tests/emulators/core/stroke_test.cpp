// A buffer passes on every stroke once and in order, and flushes waiting strokes before a pass begins or ends.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "emulators/core/stroke.hpp"

namespace sightline::core {
namespace {

// Records each stroke as its x, passes as brackets.
struct Transcript final : StrokeTaker {
  std::string text;
  std::size_t blocks = 0;
  void strokes(std::span<const Stroke> strokes) override {
    ++blocks;
    for (const Stroke& each : strokes) text += std::to_string(each.x) + ' ';
  }
  void begin_pass(Instant) override { text += "[ "; }
  void end_pass(Instant) override { text += "] "; }
};

Stroke at(std::uint16_t x) {
  return {.time = at_nanoseconds(x), .x = x};
}

TEST(StrokeBuffer, FlushesBeforeAPassBeginsOrEnds) {
  Transcript taker;
  StrokeBuffer strokes;
  strokes.hand_to(&taker);
  strokes.put(at(1));
  EXPECT_EQ(taker.text, "");
  strokes.begin_pass(at_nanoseconds(2));
  strokes.put(at(3));
  strokes.put(at(4));
  strokes.end_pass(at_nanoseconds(5));
  strokes.put(at(6));
  EXPECT_EQ(taker.text, "1 [ 3 4 ] ");
  strokes.flush();
  strokes.flush();
  EXPECT_EQ(taker.text, "1 [ 3 4 ] 6 ");
  EXPECT_EQ(taker.blocks, 3U);
}

TEST(StrokeBuffer, LosesNoStrokeBeyondItsCapacity) {
  Transcript taker;
  StrokeBuffer strokes;
  strokes.hand_to(&taker);
  std::string expected;
  for (std::uint16_t x = 0; x < 5000; ++x) {
    strokes.put(at(x));
    expected += std::to_string(x) + ' ';
  }
  EXPECT_GT(taker.blocks, 1U);
  strokes.flush();
  EXPECT_EQ(taker.text, expected);
}

// Each taker gets the strokes of its time; strokes without taker are dropped.
TEST(StrokeBuffer, TheTakerMayChange) {
  Transcript first;
  Transcript second;
  StrokeBuffer strokes;
  EXPECT_FALSE(strokes.wanted());
  strokes.put(at(1));
  strokes.begin_pass(at_nanoseconds(1));
  strokes.put(at(2));
  strokes.hand_to(&first);
  EXPECT_TRUE(strokes.wanted());
  strokes.put(at(3));
  strokes.hand_to(&second);
  strokes.put(at(4));
  strokes.hand_to(nullptr);
  strokes.put(at(5));
  strokes.flush();
  EXPECT_EQ(first.text, "3 ");
  EXPECT_EQ(second.text, "4 ");
}

}  // namespace
}  // namespace sightline::core
