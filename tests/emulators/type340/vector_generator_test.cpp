// The rate multiplier compared with reference paths, the steps of its stages, and the display's end points.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <span>
#include <sstream>
#include <string>

#include "emulators/type340/display.hpp"
#include "emulators/type340/vector_generator.hpp"
#include "tests/support/effort.hpp"

namespace sightline::type340 {
namespace {

static_assert(pulses_of_vector(0, 0) == 7);
static_assert(pulses_of_vector(7, 7) == 7);
static_assert(pulses_of_vector(8, 7) == 15);
static_assert(pulses_of_vector(15, 16) == 31);
static_assert(pulses_of_vector(32, 0) == 63);
static_assert(pulses_of_vector(0, 64) == 127);

// "dx dy pulses | x,y . x,y ..." with . for a pulse without movement.
[[nodiscard]] std::string path_of_vector(int dx, int dy) {
  RateMultiplier rate;
  int x = 0;
  int y = 0;
  std::string path;
  int pulses = 0;
  while (rate.brm != RateMultiplier::full) {
    const auto step = rate.count(static_cast<std::uint8_t>(dx), static_cast<std::uint8_t>(dy));
    x += step.x ? 1 : 0;
    y += step.y ? 1 : 0;
    path += step.x || step.y ? ' ' + std::to_string(x) + ',' + std::to_string(y) : " .";
    ++pulses;
  }
  return std::to_string(dx) + ' ' + std::to_string(dy) + ' ' + std::to_string(pulses) + " |" + path;
}

TEST(RateMultiplier, FollowsTheReferencePaths) {
  std::ifstream in(SIGHTLINE_TEST_DATA "/type340/vector-generator.golden");
  ASSERT_TRUE(in);
  int vectors = 0;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream numbers(line);
    int dx = -1;
    int dy = -1;
    ASSERT_TRUE(numbers >> dx >> dy) << line;
    EXPECT_EQ(path_of_vector(dx, dy), line);
    ++vectors;
  }
  EXPECT_EQ(vectors, 27);
}

// Every pulse of every vector, by the stage that it changes.
TEST(RateMultiplier, StagesMakeTheStepsOfThePulses) {
  for (unsigned dx = 0; dx < 128; ++dx) {
    for (unsigned dy = 0; dy < 128; ++dy) {
      const auto d = static_cast<std::uint8_t>(dx | dy);
      const auto mx = static_cast<std::uint8_t>(dx);
      const auto my = static_cast<std::uint8_t>(dy);
      RateMultiplier rate;
      bool equal = true;
      for (unsigned n = 1; n <= static_cast<unsigned>(pulses_of_vector(mx, my)); ++n) {
        const RateMultiplier::Step step = rate.count(mx, my);
        const auto stage = static_cast<unsigned>(std::countr_zero(n));
        equal = equal && step.x == ((steps_by_stage(mx, d) >> stage & 1U) != 0) && step.y == ((steps_by_stage(my, d) >> stage & 1U) != 0);
      }
      ASSERT_TRUE(equal) << dx << ',' << dy;
      ASSERT_EQ(rate.brm, RateMultiplier::full) << dx << ',' << dy;
    }
  }
}

TEST(RateMultiplier, WandersLessThanADeflectionStepAndAHalf) {
  // The worst vector of all, 53,74: 1.55 points off the ideal line.
  RateMultiplier rate;
  double worst = 0;
  int x = 0;
  int y = 0;
  for (int i = 0; i < 127; ++i) {
    const auto step = rate.count(53, 74);
    x += step.x ? 1 : 0;
    y += step.y ? 1 : 0;
    worst = std::max(worst, std::abs(74.0 * x - 53.0 * y) / std::hypot(53.0, 74.0));
  }
  EXPECT_NEAR(worst, 1.55, 0.005);
}

struct LastFlashes final : core::StrokeTaker {
  core::Stroke first;
  core::Stroke last;
  int count = 0;
  void strokes(std::span<const core::Stroke> strokes) override {
    if (count == 0) first = strokes.front();
    last = strokes.back();
    count += static_cast<int>(strokes.size());
  }
};

// A parameter word, then the vector with escape, from the beam's position.
void draw(Display& display, std::int64_t start, std::uint32_t vector) {
  display.load_address_and_start(core::at_nanoseconds(start), core::Word18(0));
  display.end_break(core::at_nanoseconds(start), core::Word18(0100117));
  display.advance(core::at_nanoseconds(start + 3300));
  ASSERT_NE(display.data_break(), nullptr);
  display.end_break(core::at_nanoseconds(start + 3300), core::Word18(vector));
  display.advance(core::at_nanoseconds(start + 400'000));
}

TEST(Display, EveryVectorStartsDarkAndEndsLitAtItsEndPoint) {
  LastFlashes flashes;
  core::StrokeBuffer strokes;
  strokes.hand_to(&flashes);
  Display display({}, strokes);
  std::int64_t t = 0;
  // To the middle of the screen: a Y and an X point word.
  for (const std::uint32_t word : {020000U, 0221000U, 01000U}) {
    if (t == 0) display.load_address_and_start(core::at_nanoseconds(t), core::Word18(0));
    display.end_break(core::at_nanoseconds(t), core::Word18(word));
    display.advance(core::at_nanoseconds(t += 40'000));
  }
  const std::uint32_t step = tests::effort(1U, 5U);
  int x = 512;
  int y = 512;
  for (std::uint32_t dx = 0; dx < 128; ++dx) {
    for (std::uint32_t dy = dx % step; dy < 128; dy += step) {
      // The four combinations of signs in turn return to the middle.
      for (const std::uint32_t signs : {0U, 0100200U, 0100000U, 0000200U, 0000200U, 0100000U, 0100200U, 0U}) {
        const int from_x = x;
        const int from_y = y;
        x += (signs & 0200U) != 0 ? -static_cast<int>(dx) : static_cast<int>(dx);
        y += (signs & 0100000U) != 0 ? -static_cast<int>(dy) : static_cast<int>(dy);
        flashes.count = 0;
        draw(display, t += 1'000'000, 0600000U | signs | dy << 8 | dx);
        strokes.flush();
        ASSERT_EQ(display.registers().x, x) << dx << ',' << dy << ',' << signs;
        ASSERT_EQ(display.registers().y, y) << dx << ',' << dy << ',' << signs;
        const core::Instant requested = core::at_nanoseconds(
            t + 3300 + 2800 + 500 + 1500 * pulses_of_vector(static_cast<std::uint8_t>(dx), static_cast<std::uint8_t>(dy)));
        ASSERT_NE(display.data_break(), nullptr);
        ASSERT_EQ(display.requested_at(), requested);
        if (dx == 0 && dy == 0) {
          ASSERT_EQ(flashes.count, 0);
          continue;
        }
        ASSERT_TRUE(flashes.first.x != from_x || flashes.first.y != from_y) << dx << ',' << dy << ',' << signs;
        ASSERT_EQ(flashes.last.x, x);
        ASSERT_EQ(flashes.last.y, y);
      }
    }
  }
}

}  // namespace
}  // namespace sightline::type340
