// Observers of an 8080 run: hooks chosen at compile time, so that a machine without an observer has none.
//
// An observer is a type with
//   static constexpr bool instructions;   true: instruction() is called after every instruction
//   static constexpr bool cycles;         true: cycle() is called for every machine cycle that has a SYNC
//   static constexpr bool stops;          true: stop() is asked at every instruction boundary
// and, for each that is true,
//   void instruction(const I8080InstructionRecord&);
//   void cycle(const I8080Cycle&);
//   bool stop(core::TStateInstant now, i8080::Address next);   true ends the run there, before the fetch from `next`; not
//                                         asked while a halt lasts
// An observer of cycles may have
//   void hold(const I8080HoldPins&);      called when one of them has changed; cycle() is told of a cycle when its byte is known
// and one that is asked
//   bool reads_machine() const;           true: stop() finds the machine's registers, time and count of instructions up to date
// It may have a filter (../core/reporter.hpp).
// An observer sees; it must not write to the machine.
#pragma once

#include <array>
#include <cstdint>

#include "../core/tstates.hpp"
#include "../i8080/bus.hpp"
#include "../i8080/state.hpp"

namespace sightline::machines {

struct I8080InstructionRecord {
  core::TStateInstant time;  // T1 of its fetch
  core::TStateInstant end;
  i8080::Address pc;                  // its address; PC, if a device supplied the instruction
  std::array<i8080::Byte, 3> bytes;   // the bytes there; as many count as the instruction is long
  bool acknowledged;                  // a device supplied it
  const i8080::State& before;
  const i8080::State& after;
};

// DAD's internal cycles have no SYNC and are not reported.
struct I8080Cycle {
  core::TStateInstant time;  // its T1
  i8080::Status status;
  i8080::Address address;
  i8080::Byte data;  // nothing on the bus in the halt cycle: 0
  bool operand = false;  // a byte of the instruction behind its opcode

  friend constexpr bool operator==(const I8080Cycle&, const I8080Cycle&) = default;
};

struct I8080HoldPins {
  core::TStateInstant time;
  bool hold;
  bool acknowledge;  // HLDA
  bool stands;       // the processor waits for the end of HOLD before its next cycle

  friend constexpr bool operator==(const I8080HoldPins&, const I8080HoldPins&) = default;
};

struct NoI8080Observer {
  static constexpr bool instructions = false;
  static constexpr bool cycles = false;
  static constexpr bool stops = false;
};

}  // namespace sightline::machines
