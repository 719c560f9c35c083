// The times of a PDP-7 that no available document specifies, each with its status, and other behaviour that none specifies.
//
// Everything that is a whole number of core cycles follows from the bus verbs of cpu.hpp and is not here. Status: confirmed
// (a DEC document), memory (figures remembered from the 1965 users handbook, not verified), unknown (chosen; the reason is
// stated). Every value can be set per machine; none depends on the host.
#pragma once

#include <array>
#include <cstdint>

#include "../core/time.hpp"

namespace sightline::pdp7 {

// One core memory cycle, 1.75 us. Confirmed (Supnik, table from Bell's "Computer Engineering").
inline constexpr core::Duration machine_cycle{1750};

struct Timing {
  // Stretch of the fetch cycle for each IOT device (bits 6-11). That slow cycles exist is confirmed (interface manual
  // F-78A, "Slow Cycle Facility"); which devices request them and for how long is unknown. Default: none.
  std::array<core::Duration, 64> iot_stretch{};

  // Asynchronous stepping of the Type 177 EAE, added to the whole cycles. Unknown; the multiply and divide steps give the
  // remembered worst cases of 6.1 us for 18 steps and 9.0 us for 19.
  core::Duration eae_setup{0};
  core::Duration eae_shift_step{140};
  core::Duration eae_normalize_step{140};
  core::Duration eae_multiply_step{144};
  core::Duration eae_divide_step{290};

  // Program interrupt: Break cycles before the fetch at 1. Unknown; the PDP-4 uses one (PDP-4 manual, page 16).
  int interrupt_cycles = 1;
  // Clock tick: Break cycles for counting location 7. Unknown; read, count and rewrite fit in one core cycle.
  int clock_tick_cycles = 1;
  // Mains frequency. Confirmed as line-driven; 50 Hz in Cambridge, 60 Hz in the United States.
  std::int64_t clock_hertz = 50;

  core::Duration reader_line{3'333'333};           // 300 lines a second; memory
  core::Duration punch_line{15'797'788};           // 63.3 lines a second; memory
  core::Duration teletype_character{100'000'000};  // 10 characters a second; memory

  // A word of the RB09 under its head. Unknown; sheets of the time give 17 ms of average access, half a turn.
  core::Duration disk_word{6'600};
  // DBCS stops a transfer in progress: unknown (the simulator lets it continue); a program that clears the status expects
  // no more words in core.
  bool disk_clear_stops = true;
  // A timing error ends the transfer: unknown; what follows would be lost anyway.
  bool disk_late_stops = true;
  // The word after the last one of the disk: unknown, assumed to be the first (the simulator's test is off by one).
  std::uint32_t disk_after_last = 0;

  // 703361 skips like SKP7, 703341: unknown; the pulse is assumed to be gated by bit 12 (040) alone, as those of ION and
  // CLON are.
  bool skip_703361 = true;
  // Codes of device 33 with several pulses, such as 703317: each pulse acts separately, in the order 1, 2, 4, as with every
  // other device here (TTS, then CAF; pulse 4 has no device). Unknown; if not, such a code does nothing.
  bool device_33_each_pulse = true;

  friend constexpr bool operator==(const Timing&, const Timing&) = default;
};

}  // namespace sightline::pdp7
