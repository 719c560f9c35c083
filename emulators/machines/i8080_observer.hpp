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
// An observer of cycles that has
//   static constexpr bool ends_of_halts = false;
// does not need HLTA in the fetch that ends a halt, which each cycle would be asked for. It may have a filter
// (../core/reporter.hpp), and
//   void hold(const I8080HoldPins&);      called when one of them has changed; cycle() is told of a cycle when its byte is known
// An observer that looks at registers (the same file) has
//   std::optional<I8080Wanted> renewed();     what it wants of a run that begins; nothing: the same as at the last run of this machine
// and its Look, in place of arrives() and of enter(),
//   static constexpr unsigned tests;      how many tests there are
//   bool hits<test>(const I8080View&) const   a test of few host instructions that may say true too often; not asked: false at all times
//   std::uint16_t tested() const          I8080Wanted::tested
// A cycle of memory is told where I8080Wanted has a mark for it, one of a port where the filter wants it.
// An observer sees; it must not write to the machine.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

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

// What an observer that looks wants of a run.
struct I8080Wanted {
  const std::uint8_t* places;    // by addresses, bit 0 set: a run is asked there
  const std::uint8_t* accesses;  // marks of I8080Store, by addresses
  bool watches;                  // there are such marks
  std::uint16_t tested;          // a set of i8080::changed: it is asked after instructions that may change one of them, if the test hits
  std::optional<unsigned> test;  // nothing: each time. Each time, too, if the instruction may change memory and that is in the set
};

template <class Observer>
inline constexpr bool wants_ends_of_halts = true;
template <class Observer>
  requires requires { Observer::ends_of_halts; }
inline constexpr bool wants_ends_of_halts<Observer> = Observer::ends_of_halts;

struct NoI8080Observer {
  static constexpr bool instructions = false;
  static constexpr bool cycles = false;
  static constexpr bool stops = false;
};

}  // namespace sightline::machines
