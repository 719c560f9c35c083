// Random core images on every kind of machine: no program may harm the host or stop time.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "emulators/core/stroke.hpp"
#include "emulators/machines/pdp7.hpp"
#include "emulators/type340/display.hpp"
#include "tests/support/effort.hpp"

namespace sightline {
namespace {

struct CheckStrokes final : core::StrokeTaker {
  void strokes(std::span<const core::Stroke> strokes) override {
    for (const core::Stroke& s : strokes) {
      ASSERT_LT(s.x, 1024U);
      ASSERT_LT(s.y, 1024U);
      ASSERT_GE(s.time, last);
      last = s.time;
    }
  }
  core::Instant last{};
};

std::unique_ptr<pdp7::Machine> machine_of(std::uint64_t seed) {
  pdp7::Options options;
  options.core_words = 4096U << (seed % 4);
  options.model.eae = (seed & 4U) != 0;
  options.model.trap_mode = (seed & 8U) != 0;
  auto machine = std::make_unique<pdp7::Machine>(options);
  const std::array<core::Setting, 2> settings{core::Setting{"347", (seed & 16U) != 0 ? 1 : 0},
                                              core::Setting{"342", (seed & 32U) != 0 ? 1 : 0}};
  EXPECT_EQ(machine->attach("display", settings), "");
  return machine;
}

type340::Display& display_of(pdp7::Machine& machine) {
  return *machine.find<type340::Display>();
}

// Runs continue after a halt. Every instruction takes at least one cycle, and at most the longest EAE step count plus the cycles
// that the display and the clock steal at one boundary.
TEST(Pdp7RandomCore, RunsWithinBoundsAndTheSameTwice) {
  NEEDS_OPTIMISED_CODE();
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    pdp7::State ends[2];
    core::Instant times[2];
    for (int again = 0; again < 2; ++again) {
      CheckStrokes strokes;
      const auto made = machine_of(seed);
      pdp7::Machine& machine = *made;
      machine.strokes().hand_to(&strokes);
      machine.randomise_core(seed);
      machine.start(static_cast<pdp7::Address>(seed * 011));
      display_of(machine).load_address_and_start(machine.now(), core::Word18(0100));
      for (int part = 0; part < 20; ++part) machine.run({500, core::never});
      const auto counts = machine.counts();
      ASSERT_LE(counts.instructions, 10'000U);
      ASSERT_GE(counts.machine_cycles, counts.instructions);
      ASSERT_LT(machine.registers().pc, 0100000U);
      for (pdp7::Address a = machine.options().core_words; a <= pdp7::address_mask; ++a) {
        ASSERT_EQ(machine.peek(a).value(), 0U) << "a write outside core at " << std::oct << a;
      }
      ends[again] = machine.registers();
      times[again] = machine.now();
    }
    ASSERT_EQ(ends[0], ends[1]);
    ASSERT_EQ(times[0], times[1]);
  }
}

// A taker of strokes changes how the display works internally, never what the processor observes.
TEST(Pdp7RandomCore, ATakerOfStrokesChangesNothingForTheProcessor) {
  for (std::uint64_t seed = 1000; seed < 1100; ++seed) {
    SCOPED_TRACE(seed);
    CheckStrokes strokes;
    const auto watched = machine_of(seed);
    watched->strokes().hand_to(&strokes);
    const auto unwatched = machine_of(seed);
    const auto run = [&](pdp7::Machine& machine) {
      machine.randomise_core(seed);
      machine.start(0200);
      machine.registers().interrupts_on = true;
      display_of(machine).load_address_and_start(machine.now(), core::Word18(0300));
      for (int part = 0; part < 20; ++part) machine.run({500, core::never});
    };
    run(*watched);
    run(*unwatched);
    ASSERT_EQ(watched->registers(), unwatched->registers());
    ASSERT_EQ(watched->now(), unwatched->now());
    ASSERT_EQ(watched->counts().stolen_cycles, unwatched->counts().stolen_cycles);
    ASSERT_EQ(display_of(*watched).counters().words, display_of(*unwatched).counters().words);
  }
}

}  // namespace
}  // namespace sightline
