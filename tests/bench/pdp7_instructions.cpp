// Emulated PDP-7 instructions (the items) per second with exact timing, in the loop LAC, TAD, DAC, ISZ, JMP: with an idle
// Type 340, and while it refreshes a picture without observer.
#include <benchmark/benchmark.h>

#include <array>
#include <cstdint>

#include "emulators/machines/pdp7.hpp"
#include "emulators/type340/display.hpp"

namespace sightline {
namespace {

constexpr int instructions_a_round = 1'000'000;
constexpr pdp7::Address loop_start = 0100;
constexpr pdp7::Address file_start = 01000;

struct Machine {
  Machine() { static_cast<void>(pdp7.attach("display")); }
  pdp7::Machine pdp7;
};

// The loop at 100. The second JMP is for the one ISZ in 2^18 that skips.
void load_loop(Machine& machine) {
  constexpr std::array<std::uint32_t, 6> loop{0200110, 0340111, 0040110, 0440112, 0600100, 0600100};
  for (std::uint32_t i = 0; i < loop.size(); ++i) machine.pdp7.deposit(loop_start + i, core::Word18(loop[i]));
  machine.pdp7.deposit(0111, core::Word18(3));
}

// Interrupt handler at 1: IDLA again with the file's address, AC kept. Returns with ION; JMP I 0.
void load_refresh(Machine& machine) {
  constexpr std::array<std::uint32_t, 7> handler{0040030, 0200032, 0700606, 0200030,
                                                 0700042, 0620000, 0740040};
  for (std::uint32_t i = 0; i < handler.size(); ++i) machine.pdp7.deposit(1 + i, core::Word18(handler[i]));
  machine.pdp7.deposit(0032, core::Word18(file_start));
}

// A picture of 100 lines, each placed by two point words and drawn by two vectors of 60 steps, then stop.
void load_picture(Machine& machine) {
  constexpr std::uint32_t point_mode = 0020117;   // parameter: point mode next, scale 0, intensity 7
  constexpr std::uint32_t vector_mode = 0100000;  // bits 2-4 of a point word: vector mode next
  constexpr std::uint32_t vertical = 0200000;     // point word for Y
  pdp7::Address at = file_start;
  for (std::uint32_t line = 0; line < 100; ++line) {
    machine.pdp7.deposit(at++, core::Word18(point_mode));
    machine.pdp7.deposit(at++, core::Word18(vertical | 0020000U | (100 + line * 8)));
    machine.pdp7.deposit(at++, core::Word18(vector_mode | 200));
    machine.pdp7.deposit(at++, core::Word18(0200000U | (074U << 8) | 044U));
    machine.pdp7.deposit(at++, core::Word18(0600000U | (044U << 8) | 074U));
  }
  machine.pdp7.deposit(at, core::Word18(0003000));  // parameter: stop, interrupt
}

void count(benchmark::State& state, const Machine& machine) {
  state.SetItemsProcessed(state.iterations() * instructions_a_round);
  const auto counts = machine.pdp7.counts();
  state.counters["stolen/instruction"] =
      static_cast<double>(counts.stolen_cycles) / static_cast<double>(counts.instructions);
}

void display_idle(benchmark::State& state) {
  Machine machine;
  load_loop(machine);
  machine.pdp7.start(loop_start);
  for (auto _ : state) machine.pdp7.run({instructions_a_round, core::never});
  count(state, machine);
}
BENCHMARK(display_idle);

void display_refreshing(benchmark::State& state) {
  Machine machine;
  load_loop(machine);
  load_refresh(machine);
  load_picture(machine);
  machine.pdp7.start(loop_start);
  machine.pdp7.registers().interrupts_on = true;
  machine.pdp7.find<type340::Display>()->load_address_and_start(machine.pdp7.now(), core::Word18(file_start));
  for (auto _ : state) machine.pdp7.run({instructions_a_round, core::never});
  count(state, machine);
  const auto& display = machine.pdp7.find<type340::Display>()->counters();
  state.counters["passes/s emulated"] =
      static_cast<double>(display.passes_stopped) /
      (static_cast<double>(core::nanoseconds_of(machine.pdp7.now())) * 1e-9);
}
BENCHMARK(display_refreshing);

}  // namespace
}  // namespace sightline
