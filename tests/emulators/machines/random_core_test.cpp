// Random core images run on every kind of machine: nothing a program can do may harm the host or stop time.
#include <gtest/gtest.h>

#include <cstdint>
#include <span>

#include "emulators/core/stroke.hpp"
#include "emulators/machines/pdp7.hpp"
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

machines::Pdp7Options machine_of(std::uint64_t seed) {
  machines::Pdp7Options options;
  options.configuration.core_words = 4096U << (seed % 4);
  options.configuration.model.eae = (seed & 4U) != 0;
  options.configuration.model.trap_mode = (seed & 8U) != 0;
  type340::Options display;
  display.subroutines_347 = (seed & 16U) != 0;
  display.characters_342 = (seed & 32U) != 0;
  options.display = display;
  return options;
}

// Runs go on after a halt; every instruction takes at least a cycle, and at most the longest EAE step count
// plus what the display and the clock steal at one boundary.
TEST(Pdp7RandomCore, RunsWithinBoundsAndTheSameTwice) {
  NEEDS_OPTIMISED_CODE();
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    pdp7::State ends[2];
    core::Instant times[2];
    for (int again = 0; again < 2; ++again) {
      CheckStrokes strokes;
      machines::NoObserver observer;
      machines::Pdp7<> machine(machine_of(seed), observer);
      machine.strokes().hand_to(&strokes);
      machine.randomise_core(seed);
      machine.start(static_cast<pdp7::Address>(seed * 011));
      machine.display()->load_address_and_start(machine.now(), core::Word18(0100));
      for (int part = 0; part < 20; ++part) machine.run({500, core::never});
      const auto counts = machine.counts();
      ASSERT_LE(counts.instructions, 10'000U);
      ASSERT_GE(counts.machine_cycles, counts.instructions);
      ASSERT_LT(machine.registers().pc, 0100000U);
      for (pdp7::Address a = machine.configuration().core_words; a <= pdp7::address_mask; ++a) {
        ASSERT_EQ(machine.peek(a).value(), 0U) << "a write outside core at " << std::oct << a;
      }
      ends[again] = machine.registers();
      times[again] = machine.now();
    }
    ASSERT_EQ(ends[0], ends[1]);
    ASSERT_EQ(times[0], times[1]);
  }
}

// Whether strokes are wanted decides how the display works inside, never what the processor sees.
TEST(Pdp7RandomCore, ATakerOfStrokesChangesNothingForTheProcessor) {
  for (std::uint64_t seed = 1000; seed < 1100; ++seed) {
    SCOPED_TRACE(seed);
    CheckStrokes strokes;
    machines::NoObserver observer;
    machines::Pdp7<> watched(machine_of(seed), observer);
    watched.strokes().hand_to(&strokes);
    machines::Pdp7<> unwatched(machine_of(seed), observer);
    const auto run = [&](auto& machine) {
      machine.randomise_core(seed);
      machine.start(0200);
      machine.registers().interrupts_on = true;
      machine.display()->load_address_and_start(machine.now(), core::Word18(0300));
      for (int part = 0; part < 20; ++part) machine.run({500, core::never});
    };
    run(watched);
    run(unwatched);
    ASSERT_EQ(watched.registers(), unwatched.registers());
    ASSERT_EQ(watched.now(), unwatched.now());
    ASSERT_EQ(watched.counts().stolen_cycles, unwatched.counts().stolen_cycles);
    ASSERT_EQ(watched.display()->counters().words, unwatched.display()->counters().words);
  }
}

}  // namespace
}  // namespace sightline
