// A display that is advanced at its deadlines executes whole words; one that is advanced every 50 ns makes each pulse. Both run
// random files side by side, started, cleared, resumed and read at random instants. Registers, requests and interrupt requests
// must agree at every access; so must the flashes, which the first display emits in every other file.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "emulators/type340/display.hpp"
#include "tests/support/effort.hpp"

namespace sightline::type340 {
namespace {

struct Flashes final : core::StrokeTaker {
  std::vector<core::Stroke> all;
  bool in_order = true;
  void strokes(std::span<const core::Stroke> strokes) override {
    for (const core::Stroke& s : strokes) {
      in_order = in_order && (all.empty() || s.time >= all.back().time) && s.x < 1024 && s.y < 1024 && s.intensity < 8;
      all.push_back(s);
    }
  }
};

using Memory = std::array<core::Word18, 64>;
using Random = std::mt19937;

[[nodiscard]] std::uint32_t below(Random& random, std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); }

// Words that mostly draw: a mode word, then a run of words of that mode.
[[nodiscard]] Memory random_memory(Random& random) {
  constexpr std::uint32_t modes[] = {1, 1, 3, 4, 4, 5, 6, 7};
  Memory memory;
  for (auto& word : memory) {
    const std::uint32_t kind = below(random, 8);
    std::uint32_t value = random() & core::Word18::mask;
    if (kind < 3) value = modes[below(random, 8)] << 13 | (random() & 0177U) | (below(random, 4) == 0 ? 034000U : 0U);
    if (kind == 3) value = 0200000U | (random() & 0100200U) | below(random, 8) << 8 | below(random, 8);
    word = core::Word18(value);
  }
  return memory;
}

// A display, its memory, and a break that is granted one cycle after the request.
struct Rig {
  Rig(const Options& options, const Memory& words, core::StrokeTaker* taker) : display(options, strokes), memory(words) {
    strokes.hand_to(taker);
  }

  core::StrokeBuffer strokes;
  Display display;
  const Memory& memory;

  [[nodiscard]] core::Instant served_at() const { return display.requested_at() + core::Duration(1750); }

  // Makes all transfers up to `now` and advances the display to `now`.
  void run(core::Instant now) {
    while (const core::DataBreak* request = display.data_break()) {
      if (served_at() > now) break;
      display.end_break(served_at(), memory[request->address % memory.size()]);
    }
  }

  [[nodiscard]] core::Instant next() const { return display.data_break() == nullptr ? display.deadline() : served_at(); }

  // As a machine does: from one deadline to the next.
  void run_by_deadlines(core::Instant now) {
    while (next() <= now) {
      const core::Instant at = next();
      display.advance(at);
      const bool asks = display.data_break() != nullptr;
      ASSERT_TRUE(asks ? display.deadline() <= at : display.deadline() > at);  // or a machine would make no progress
      run(at);
    }
    if (display.data_break() != nullptr) display.advance(now);  // it is always due
  }
};

template <class Operation>
void both(Rig& pulses, Rig& words, Operation operation) {
  operation(pulses.display);
  operation(words.display);
}

void touch_at_random(Random& random, core::Instant now, Rig& pulses, Rig& words) {
  const std::uint32_t kind = below(random, 40);
  const core::Word18 address(random() & 077U);
  if (kind == 0) both(pulses, words, [&](Display& d) { d.clear_flags(now); });
  if (kind == 1) both(pulses, words, [&](Display& d) { d.resume(now); });
  if (kind == 2) both(pulses, words, [&](Display& d) { d.restart(now); });
  if (kind == 3) both(pulses, words, [&](Display& d) { d.power_clear(now); });
  if (kind > 3 && kind < 8) both(pulses, words, [&](Display& d) { d.load_address_and_start(now, address); });
  if (kind < 20) {
    EXPECT_EQ(pulses.display.coordinates(now), words.display.coordinates(now));
    EXPECT_EQ(pulses.display.registers(), words.display.registers());
  }
}

void compare_outside(core::Instant now, const Rig& pulses, const Rig& words) {
  const core::DataBreak* a = pulses.display.data_break();
  const core::DataBreak* b = words.display.data_break();
  ASSERT_EQ(a == nullptr, b == nullptr) << core::nanoseconds_of(now);
  if (a != nullptr) {
    ASSERT_EQ(pulses.display.requested_at(), words.display.requested_at());
    ASSERT_EQ(a->address, b->address);
    ASSERT_EQ(a->direction, b->direction);
    ASSERT_EQ(a->word, b->word);
  }
  ASSERT_EQ(pulses.display.interrupt_request(), words.display.interrupt_request()) << core::nanoseconds_of(now);
}

void run_side_by_side(Random& random, std::uint64_t& flashes) {
  const Memory memory = random_memory(random);
  const Options options{.subroutines_347 = below(random, 2) == 0,
                        .characters_342 = below(random, 2) == 0,
                        .flash_again = below(random, 2) == 0};
  Flashes of_pulses;
  Flashes of_words;
  const bool wanted = below(random, 2) == 0;
  Rig pulses(options, memory, &of_pulses);
  Rig words(options, memory, wanted ? &of_words : nullptr);
  if (below(random, 4) == 0) {
    const LightPen pen{.left = 0, .bottom = 0, .right = 700, .top = 700, .delay = core::Duration(50 * below(random, 29))};
    both(pulses, words, [&](Display& d) { d.point_light_pen(pen); });
  }
  both(pulses, words, [](Display& d) { d.load_address_and_start(core::Instant{}, core::Word18(0)); });
  core::Instant touch{};
  for (core::Instant now{}; now < core::at_nanoseconds(2'000'000); now += core::Duration(50)) {
    pulses.display.advance(now);
    pulses.run(now);
    words.run_by_deadlines(now);
    compare_outside(now, pulses, words);
    if (pulses.display.data_break() != nullptr && pulses.display.requested_at() == now) {
      EXPECT_EQ(pulses.display.registers(), words.display.registers()) << core::nanoseconds_of(now);
    }
    if (::testing::Test::HasFailure()) return;
    if (now < touch) continue;
    touch_at_random(random, now, pulses, words);
    touch = now + core::Duration(50 * below(random, 2000));
  }
  pulses.strokes.flush();
  words.display.advance(core::at_nanoseconds(2'000'000));
  pulses.display.advance(core::at_nanoseconds(2'000'000));
  words.strokes.flush();
  EXPECT_TRUE(of_pulses.in_order);
  if (wanted) {
    EXPECT_EQ(of_words.all, of_pulses.all);
  }
  flashes += of_pulses.all.size();
}

TEST(Display, WholeWordsAgreeWithPulsesAtEveryAccess) {
  Random random(340);
  std::uint64_t flashes = 0;
  for (int file = 0; file < tests::effort(200, 30); ++file) {
    run_side_by_side(random, flashes);
    ASSERT_FALSE(HasFailure()) << "file " << file;
  }
  EXPECT_GT(flashes, tests::effort(10'000U, 1500U));
}

// Random words, started twenty times per file.
TEST(Display, RandomWordsNeitherHangNorLeaveTheScreen) {
  Random random(7);
  std::size_t flashes = 0;
  for (int file = 0; file < 200; ++file) {
    Memory memory;
    for (auto& word : memory) word = core::Word18(random() & core::Word18::mask);
    Flashes taken;
    Rig rig({.subroutines_347 = file % 2 == 0, .characters_342 = file % 3 == 0}, memory, &taken);
    if (file % 5 == 0) rig.display.point_light_pen(LightPen{.right = 1023, .top = 511});
    for (std::int64_t t = 0; t < 20'000'000; t += 1'000'000) {
      rig.display.load_address_and_start(core::at_nanoseconds(t), core::Word18(random() & core::Word18::mask));
      rig.run_by_deadlines(core::at_nanoseconds(t + 1'000'000));
      ASSERT_FALSE(HasFailure()) << "file " << file;
      ASSERT_LT(rig.display.registers().x, 1024);
      ASSERT_LT(rig.display.registers().y, 1024);
    }
    rig.strokes.flush();
    ASSERT_TRUE(taken.in_order) << "file " << file;
    flashes += taken.all.size();
  }
  EXPECT_GT(flashes, 10'000U);
}

// Vector continue of (0, 0), lit: it never flashes and never ends, and an hour of it is skipped at once. The rate multiplier then
// has the state that so many pulses give.
TEST(Display, EndlessVectorContinueCostsNothing) {
  Flashes flashes;
  core::StrokeBuffer strokes;
  strokes.hand_to(&flashes);
  Display display({}, strokes);
  display.point_light_pen(LightPen{.right = 1023, .top = 1023});
  display.load_address_and_start(core::Instant{}, core::Word18(0));
  display.end_break(core::Instant{}, core::Word18(0120117));
  display.advance(core::at_nanoseconds(3300));
  display.end_break(core::at_nanoseconds(3300), core::Word18(0200000));
  // The first pulse comes at 6600.
  RateMultiplier expected;
  for (std::int64_t pulse = 1; pulse <= 40; ++pulse) {
    static_cast<void>(expected.count(0, 0));
    const core::Instant at = core::at_nanoseconds(6600 + (pulse - 1) * 1500);
    display.advance(at);
    ASSERT_EQ(display.registers().rate, expected) << pulse;
    ASSERT_EQ(display.deadline(), core::never) << pulse;
    ASSERT_EQ(display.next_pulse(), at + core::Duration(1000)) << pulse;
  }
  // An hour later comes pulse 2,400,000,001: the first of a cycle of eight.
  const auto hour = core::at_nanoseconds(6600) + core::seconds(3600);
  display.advance(hour);
  RateMultiplier one;
  static_cast<void>(one.count(0, 0));
  EXPECT_EQ(display.registers().rate, one);
  EXPECT_EQ(display.next_pulse(), hour + core::Duration(1000));
  EXPECT_EQ(display.deadline(), core::never);
  EXPECT_EQ(display.data_break(), nullptr);
  display.advance(core::never);
  strokes.flush();
  EXPECT_TRUE(flashes.all.empty());
  // It answers an IDLA like any other word.
  display.load_address_and_start(core::never - core::milliseconds(1), core::Word18(0100));
  ASSERT_NE(display.data_break(), nullptr);
  EXPECT_EQ(display.data_break()->address, 0100);
}

}  // namespace
}  // namespace sightline::type340
