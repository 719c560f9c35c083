// A display nobody watches takes its pulses in bulk; one whose flashes are taken makes each. Both run random files side
// by side, started, cleared, resumed and read at random instants: registers, requests and interrupt request must agree
// at every touch, and the unwatched one may be advanced at its own deadlines only.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>

#include "emulators/type340/display.hpp"
#include "tests/support/effort.hpp"

namespace sightline::type340 {
namespace {

struct CountFlashes {
  static constexpr bool consumes = true;
  std::uint64_t flashes = 0;
  core::Instant last{};
  bool in_order = true;
  void begin_pass(core::Instant) {}
  void stroke(const core::Stroke& s) {
    ++flashes;
    in_order = in_order && s.time >= last && s.x < 1024 && s.y < 1024 && s.intensity < 8;
    last = s.time;
  }
  void end_pass(core::Instant) {}
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

// A display, its memory, and the break that reaches it one cycle after the request.
template <class Sink>
struct Rig {
  Display<Sink> display;
  const Memory* memory;
  core::Duration latency;

  // All deliveries up to now; the display ends at now.
  void run(core::Instant now) {
    for (;;) {
      const BreakRequest* request = display.break_request();
      if (request == nullptr || request->since + latency > now) break;
      if (request->write) {
        display.deposited(request->since + latency);
      } else {
        display.deliver(request->since + latency, (*memory)[request->address % memory->size()]);
      }
    }
  }

  [[nodiscard]] core::Instant next() const {
    const BreakRequest* request = display.break_request();
    return request == nullptr ? display.deadline() : std::min(display.deadline(), request->since + latency);
  }

  // As a machine: from one thing to do to the next.
  void run_by_deadlines(core::Instant now) {
    while (next() <= now) {
      const core::Instant at = next();
      display.advance(at);
      ASSERT_GT(display.deadline(), at);  // or a machine would not get on
      run(at);
    }
  }
};

template <class Operation>
void both(Rig<CountFlashes>& watched, Rig<core::NoStrokes>& unwatched, Operation operation) {
  operation(watched.display);
  operation(unwatched.display);
}

void touch_at_random(Random& random, core::Instant now, Rig<CountFlashes>& watched, Rig<core::NoStrokes>& unwatched) {
  const std::uint32_t kind = below(random, 40);
  const core::Word18 address(random() & 077U);
  if (kind == 0) both(watched, unwatched, [&](auto& d) { d.clear_flags(now); });
  if (kind == 1) both(watched, unwatched, [&](auto& d) { d.resume(now); });
  if (kind == 2) both(watched, unwatched, [&](auto& d) { d.restart(now); });
  if (kind == 3) both(watched, unwatched, [&](auto& d) { d.power_clear(now); });
  if (kind > 3 && kind < 8) both(watched, unwatched, [&](auto& d) { d.load_address_and_start(now, address); });
  if (kind < 20) {
    EXPECT_EQ(watched.display.coordinates(now), unwatched.display.coordinates(now));
    EXPECT_EQ(watched.display.registers(), unwatched.display.registers());
  }
}

void compare_outside(core::Instant now, const Rig<CountFlashes>& watched, const Rig<core::NoStrokes>& unwatched) {
  const BreakRequest* a = watched.display.break_request();
  const BreakRequest* b = unwatched.display.break_request();
  ASSERT_EQ(a == nullptr, b == nullptr) << core::nanoseconds_of(now);
  if (a != nullptr) {
    ASSERT_EQ(a->since, b->since);
    ASSERT_EQ(a->address, b->address);
    ASSERT_EQ(a->write, b->write);
    ASSERT_EQ(a->word, b->word);
  }
  ASSERT_EQ(watched.display.interrupt_request(), unwatched.display.interrupt_request()) << core::nanoseconds_of(now);
}

void run_side_by_side(Random& random, std::uint64_t& flashes) {
  const Memory memory = random_memory(random);
  const Options options{.subroutines_347 = below(random, 2) == 0,
                        .characters_342 = below(random, 2) == 0,
                        .flash_again = below(random, 2) == 0};
  CountFlashes sink;
  core::NoStrokes none;
  const core::Duration latency(1750);
  Rig<CountFlashes> watched{{options, sink}, &memory, latency};
  Rig<core::NoStrokes> unwatched{{options, none}, &memory, latency};
  if (below(random, 4) == 0) {
    const LightPen pen{.left = 0, .bottom = 0, .right = 700, .top = 700, .delay = core::Duration(50 * below(random, 29))};
    both(watched, unwatched, [&](auto& d) { d.point_light_pen(pen); });
  }
  both(watched, unwatched, [](auto& d) { d.load_address_and_start(core::Instant{}, core::Word18(0)); });
  core::Instant touch{};
  for (core::Instant now{}; now < core::at_nanoseconds(2'000'000); now += core::Duration(50)) {
    watched.display.advance(now);
    watched.run(now);
    unwatched.run_by_deadlines(now);
    compare_outside(now, watched, unwatched);
    if (const BreakRequest* request = watched.display.break_request(); request != nullptr && request->since == now) {
      EXPECT_EQ(watched.display.registers(), unwatched.display.registers()) << core::nanoseconds_of(now);
    }
    if (::testing::Test::HasFailure()) return;
    if (now < touch) continue;
    touch_at_random(random, now, watched, unwatched);
    touch = now + core::Duration(50 * below(random, 2000));
  }
  EXPECT_TRUE(sink.in_order);
  flashes += sink.flashes;
}

TEST(UnwatchedDisplay, AgreesWithTheWatchedOneAtEveryTouch) {
  Random random(340);
  std::uint64_t flashes = 0;
  for (int file = 0; file < tests::effort(200, 30); ++file) {
    run_side_by_side(random, flashes);
    ASSERT_FALSE(HasFailure()) << "file " << file;
  }
  EXPECT_GT(flashes, tests::effort(10'000U, 1500U));
}

// Any words, started again twenty times per file.
TEST(Display, RandomWordsNeitherHangNorLeaveTheScreen) {
  Random random(7);
  CountFlashes sink;
  for (int file = 0; file < 200; ++file) {
    Memory memory;
    for (auto& word : memory) word = core::Word18(random() & core::Word18::mask);
    Rig<CountFlashes> rig{{{.subroutines_347 = file % 2 == 0, .characters_342 = file % 3 == 0}, sink}, &memory,
                          core::Duration(1750)};
    if (file % 5 == 0) rig.display.point_light_pen(LightPen{.right = 1023, .top = 511});
    sink.last = {};
    for (std::int64_t t = 0; t < 20'000'000; t += 1'000'000) {
      rig.display.load_address_and_start(core::at_nanoseconds(t), core::Word18(random() & core::Word18::mask));
      rig.run_by_deadlines(core::at_nanoseconds(t + 1'000'000));
      ASSERT_FALSE(HasFailure()) << "file " << file;
      ASSERT_TRUE(sink.in_order) << "file " << file;
      ASSERT_LT(rig.display.registers().x, 1024);
      ASSERT_LT(rig.display.registers().y, 1024);
    }
  }
  EXPECT_GT(sink.flashes, 10'000U);
}

// Vector continue of (0, 0), lit: nothing flashes, nothing ends, and an hour of it passes at once.
TEST(Display, EndlessVectorContinueCostsNothing) {
  CountFlashes sink;
  Display display({}, sink);
  display.point_light_pen(LightPen{.right = 1023, .top = 1023});
  display.load_address_and_start(core::Instant{}, core::Word18(0));
  display.deliver(core::Instant{}, core::Word18(0120117));
  display.advance(core::at_nanoseconds(3300));
  display.deliver(core::at_nanoseconds(3300), core::Word18(0200000));
  const auto hour = core::at_nanoseconds(0) + core::seconds(3600);
  display.advance(hour);
  EXPECT_EQ(display.deadline(), core::never);
  EXPECT_EQ(display.break_request(), nullptr);
  display.advance(core::never);
  EXPECT_EQ(sink.flashes, 0U);
}

}  // namespace
}  // namespace sightline::type340
