// What goes into a run of the PDP-7 and what comes out: how the machine is put together, when to stop, why it
// stopped, and what was counted.
#pragma once

#include <cstdint>

#include "emulators/core/time.hpp"
#include "emulators/pdp7/cpu.hpp"
#include "emulators/pdp7/peripherals.hpp"
#include "emulators/pdp7/state.hpp"
#include "emulators/pdp7/timing.hpp"

namespace sightline::machines {

struct Configuration {
  std::uint32_t core_words = 8192;  // 4096, 8192, 16384 or 32768
  pdp7::Model model{};              // extend is implied by more than 8192 words
  pdp7::Devices devices{};
  pdp7::Timing timing{};
};

enum class StopReason : std::uint8_t {
  halt,               // HLT
  instruction_limit,  // Limits::instructions done
  time_limit,         // the first boundary at or after Limits::until
  observer,           // the observer asked for it
  xct_chain,          // more than 16 XCTs in a chain
  unanswered,         // strict: an instruction nothing in this machine obeys
};

struct Limits {
  std::uint64_t instructions = ~std::uint64_t{0};
  core::Instant until = core::never;
};

struct Counts {
  std::uint64_t instructions = 0;
  std::uint64_t machine_cycles = 0;  // stolen ones included, asynchronous time not
  std::uint64_t stolen_cycles = 0;   // data breaks and clock ticks; the display counts its own words
};

// An instruction nothing obeyed: how often, and where first.
struct Unanswered {
  std::uint32_t word;
  std::uint64_t count;
  pdp7::Address first_pc;
};

}  // namespace sightline::machines
