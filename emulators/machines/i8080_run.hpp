// The inputs and results of a run of the 8080, and the ports of a machine without devices.
//
// Ports are everything outside the processor and its memory. A type of ports has
//   static constexpr bool waits;                       true: wait_states() is asked in every cycle
//   std::uint8_t in(std::uint8_t port, TStateInstant)           at T3 of the input cycle
//   void out(std::uint8_t port, std::uint8_t, TStateInstant)    at T3 of the output cycle
//   std::uint8_t acknowledge(TStateInstant)            the byte a device puts on the bus at T3 of an acknowledge cycle
//   void advance(TStateInstant)                        all that happens up to and including it has happened
//   TStateInstant deadline() const                     nothing visible to the processor changes by itself before it
//   bool interrupt() const                             INT, as of the last of the calls above
//   bool stopped() const                               the run is to end at the next instruction boundary
//   int wait_states(i8080::CycleKind, i8080::Address, TStateInstant)   where `waits`: TWs, READY first low in that T2
// Ports may have
//   bool wants_look() const                            false: the last access changed none of deadline(), interrupt() and stopped()
// Without it each access is followed by a look at all three.
// Times never decrease from call to call, except that advance() may name an instant that is past.
// Ports that ask for HOLD know beforehand when; without these two the machine has no HOLD:
//   TStateInstant next_hold(TStateInstant t) const     the first T-state at or after t in which HOLD is high, or never_t
//   TStateInstant hold_ends(TStateInstant t) const     the first at or after t in which it is low; there is one
#pragma once

#include <cstdint>

#include "../core/tstates.hpp"

namespace sightline::machines {

enum class I8080StopReason : std::uint8_t {
  halt,               // HLT, and no interrupt can ever end it
  instruction_limit,  // I8080Limits::instructions done
  time_limit,         // the first boundary at or after I8080Limits::until
  observer,           // the observer asked for it
  ports,              // the ports asked for it
};

struct I8080Limits {
  std::uint64_t instructions = ~std::uint64_t{0};
  core::TStateInstant until = core::never_t;
};

template <class Ports>
concept HoldingPorts = requires(const Ports& ports, core::TStateInstant t) {
  ports.next_hold(t);
  ports.hold_ends(t);
};

// No device at this port: the data bus floats high.
struct NoI8080Ports {
  static constexpr bool waits = false;
  std::uint8_t in(std::uint8_t, core::TStateInstant) { return 0xFF; }
  void out(std::uint8_t, std::uint8_t, core::TStateInstant) {}
  std::uint8_t acknowledge(core::TStateInstant) { return 0xFF; }
  void advance(core::TStateInstant) {}
  [[nodiscard]] core::TStateInstant deadline() const { return core::never_t; }
  [[nodiscard]] bool interrupt() const { return false; }
  [[nodiscard]] bool stopped() const { return false; }
};

}  // namespace sightline::machines
