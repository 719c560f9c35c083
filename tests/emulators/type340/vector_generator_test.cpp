// The rate multiplier against reference paths, its closed form against its pulses, and the display's end points.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include "emulators/type340/display.hpp"
#include "emulators/type340/vector_flashes.hpp"
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

// Every vector whose first pulse moves the beam, in each direction, with steps of 1 and 8 points, from a corner of the screen that
// makes one field borrow from the other.
TEST(VectorFlashes, AreThePulses) {
  std::size_t compared = 0;
  for (unsigned dx = 0; dx < 128; ++dx) {
    for (unsigned dy = 0; dy < 128; ++dy) {
      const auto d = static_cast<std::uint8_t>(dx | dy);
      const unsigned steps_x = steps_by_stage(static_cast<std::uint8_t>(dx), d);
      const unsigned steps_y = steps_by_stage(static_cast<std::uint8_t>(dy), d);
      if (((steps_x | steps_y) & 1U) == 0) continue;
      for (unsigned way = 0; way < 8; ++way) {
        const std::int32_t step = (way & 4U) != 0 ? 8 : 1;
        const std::int32_t right = (way & 1U) != 0 ? -step : step;
        const std::int32_t up = (way & 2U) != 0 ? -step : step;
        const core::Stroke from{.time = core::at_nanoseconds(1'234'567'890'123),
                                .x = static_cast<std::uint16_t>(right < 0 ? 1023 : 0),
                                .y = static_cast<std::uint16_t>(up < 0 ? 1023 : 0),
                                .intensity = static_cast<std::uint8_t>(way),
                                .address = 017777};
        std::array<core::Stroke, 129> found;
        found.fill({.time = core::never});
        const int count = pulses_of_vector(static_cast<std::uint8_t>(dx), static_cast<std::uint8_t>(dy));
        VectorFlashes(from, steps_x, steps_y, right, up).put(&found[1], count);
        RateMultiplier rate;
        core::Stroke expected = from;
        for (int n = 1; n <= count; ++n) {
          const auto passed = rate.count(static_cast<std::uint8_t>(dx), static_cast<std::uint8_t>(dy));
          if (passed.x) expected.x = static_cast<std::uint16_t>(expected.x + right);
          if (passed.y) expected.y = static_cast<std::uint16_t>(expected.y + up);
          ASSERT_EQ(found[static_cast<std::size_t>(n)], expected) << dx << ' ' << dy << " way " << way << " pulse " << n;
          expected.time += timing::pulse;
          ++compared;
        }
        ASSERT_EQ(found[0].time, core::never) << dx << ' ' << dy;
        ASSERT_EQ(found[static_cast<std::size_t>(count) + 1].time, core::never) << dx << ' ' << dy;
      }
    }
  }
  EXPECT_GT(compared, 10'000'000U);
}

TEST(RateMultiplier, ClosedFormIsThePulses) {
  for (unsigned dx = 0; dx < 128; ++dx) {
    for (unsigned dy = 0; dy < 128; ++dy) {
      const auto d = static_cast<std::uint8_t>(dx | dy);
      const auto mx = static_cast<std::uint8_t>(dx);
      const auto my = static_cast<std::uint8_t>(dy);
      RateMultiplier rate;
      std::int64_t x = 0;
      bool equal = true;
      // Two turns and a bit, as vector continue runs.
      const std::int64_t turn = pulses_per_turn(d);
      for (std::int64_t n = 1; n <= 2 * turn + 3; ++n) {
        if (rate.count(mx, my).x) equal = equal && pulse_of_step(mx, d, ++x) == n;
        equal = equal && rate.brm == brm_after(d, n) && x == steps_after(mx, d, n) && pulses_at(d, rate.brm) == n % turn;
      }
      ASSERT_TRUE(equal) << dx << ',' << dy;
      ASSERT_EQ(steps_after(my, d, pulses_of_vector(mx, my)), my) << dx << ',' << dy;
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

struct LastFlashes {
  static constexpr bool consumes = true;
  core::Stroke first;
  core::Stroke last;
  int count = 0;
  void begin_pass(core::Instant) {}
  void stroke(const core::Stroke& s) {
    if (count++ == 0) first = s;
    last = s;
  }
  void end_pass(core::Instant) {}
};

// A parameter word, then the vector with escape, from where the beam is.
void draw(Display<LastFlashes>& display, std::int64_t start, std::uint32_t vector) {
  display.load_address_and_start(core::at_nanoseconds(start), core::Word18(0));
  display.deliver(core::at_nanoseconds(start), core::Word18(0100117));
  display.advance(core::at_nanoseconds(start + 3300));
  ASSERT_NE(display.break_request(), nullptr);
  display.deliver(core::at_nanoseconds(start + 3300), core::Word18(vector));
  display.advance(core::at_nanoseconds(start + 400'000));
}

TEST(Display, EveryVectorStartsDarkAndEndsLitAtItsEndPoint) {
  LastFlashes sink;
  Display display({}, sink);
  std::int64_t t = 0;
  // To the middle of the screen: a Y and an X point word.
  for (const std::uint32_t word : {020000U, 0221000U, 01000U}) {
    if (t == 0) display.load_address_and_start(core::at_nanoseconds(t), core::Word18(0));
    display.deliver(core::at_nanoseconds(t), core::Word18(word));
    display.advance(core::at_nanoseconds(t += 40'000));
  }
  const std::uint32_t step = tests::effort(1U, 5U);
  int x = 512;
  int y = 512;
  for (std::uint32_t dx = 0; dx < 128; ++dx) {
    for (std::uint32_t dy = dx % step; dy < 128; dy += step) {
      // Four signs one after the other return to the middle.
      for (const std::uint32_t signs : {0U, 0100200U, 0100000U, 0000200U, 0000200U, 0100000U, 0100200U, 0U}) {
        const int from_x = x;
        const int from_y = y;
        x += (signs & 0200U) != 0 ? -static_cast<int>(dx) : static_cast<int>(dx);
        y += (signs & 0100000U) != 0 ? -static_cast<int>(dy) : static_cast<int>(dy);
        sink.count = 0;
        draw(display, t += 1'000'000, 0600000U | signs | dy << 8 | dx);
        ASSERT_EQ(display.registers().x, x) << dx << ',' << dy << ',' << signs;
        ASSERT_EQ(display.registers().y, y) << dx << ',' << dy << ',' << signs;
        const core::Instant requested = core::at_nanoseconds(
            t + 3300 + 2800 + 500 + 1500 * pulses_of_vector(static_cast<std::uint8_t>(dx), static_cast<std::uint8_t>(dy)));
        ASSERT_NE(display.break_request(), nullptr);
        ASSERT_EQ(display.break_request()->since, requested);
        if (dx == 0 && dy == 0) {
          ASSERT_EQ(sink.count, 0);
          continue;
        }
        ASSERT_TRUE(sink.first.x != from_x || sink.first.y != from_y) << dx << ',' << dy << ',' << signs;
        ASSERT_EQ(sink.last.x, x);
        ASSERT_EQ(sink.last.y, y);
      }
    }
  }
}

}  // namespace
}  // namespace sightline::type340
