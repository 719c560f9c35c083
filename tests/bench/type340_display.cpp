// Host time of the Type 340 alone, from deadline to deadline as a machine drives it: a line drawing of sixteen separate vectors
// (point Y, point X, vector), without taker of the flashes (items are display words) and with a taker of every flash (items
// are strokes).
#include <benchmark/benchmark.h>

#include <array>
#include <cstdint>
#include <span>

#include "emulators/type340/display.hpp"

namespace sightline::type340 {
namespace {

struct CountFlashes final : core::StrokeTaker {
  std::int64_t flashes = 0;
  void strokes(std::span<const core::Stroke> strokes) override { flashes += static_cast<std::int64_t>(strokes.size()); }
};

using Memory = std::array<core::Word18, 80>;

[[nodiscard]] Memory drawing() {
  Memory memory;
  std::size_t n = 0;
  memory[n++] = core::Word18(0020117);
  for (std::uint32_t i = 0; i < 16; ++i) {
    memory[n++] = core::Word18(0220000U | (200 + 20 * i));
    memory[n++] = core::Word18(0100000U | (300 + 10 * i));
    memory[n++] = core::Word18(0600000U | (7 * i) << 8 | (127 - 5 * i));
    memory[n++] = core::Word18(i == 15 ? 0003000U : 0020000U);
  }
  return memory;
}

void draw_pass(Display& display, const Memory& memory, core::Instant& now) {
  display.load_address_and_start(now, core::Word18(0));
  while (!display.interrupt_request()) {
    if (const core::DataBreak* request = display.data_break(); request != nullptr) {
      now = display.requested_at() + core::Duration(1750);
      display.end_break(now, memory[request->address]);
    }
    now = display.deadline();
    display.advance(now);
  }
}

void unwatched_pass(benchmark::State& state) {
  core::StrokeBuffer strokes;
  Display display({}, strokes);
  const Memory memory = drawing();
  core::Instant now{};
  for (auto _ : state) draw_pass(display, memory, now);
  state.SetItemsProcessed(static_cast<std::int64_t>(display.counters().words));
}
BENCHMARK(unwatched_pass)->Name("display_words_unwatched");

void watched_pass(benchmark::State& state) {
  CountFlashes flashes;
  core::StrokeBuffer strokes;
  strokes.hand_to(&flashes);
  Display display({}, strokes);
  const Memory memory = drawing();
  core::Instant now{};
  for (auto _ : state) draw_pass(display, memory, now);
  state.SetItemsProcessed(flashes.flashes);
}
BENCHMARK(watched_pass)->Name("display_strokes_watched");

}  // namespace
}  // namespace sightline::type340
