// Observers of a PDP-7 run: hooks chosen at compile time, so that a machine without an observer has none.
//
// An observer is a type with
//   static constexpr bool instructions;   true: instruction() is called after every instruction
//   static constexpr bool cycles;         true: cycle() is called for every bus event, stolen cycles included
//   static constexpr bool stops;          true: stop() is asked at every instruction boundary
// and, for each that is true,
//   void instruction(const InstructionRecord&);
//   void cycle(const pdp7::Cycle&);
//   bool stop(core::Instant now, pdp7::Address next);   true ends the run there, before the fetch from `next`
// An observer that is asked may have
//   bool reads_machine() const;   true: stop() finds the machine's registers, time and counts up to date; the display's flags come there
//                                 when they are asked for
// and a filter (../core/reporter.hpp).
// An observer sees; it must not write to the machine.
#pragma once

#include "../core/time.hpp"
#include "../core/word.hpp"
#include "../pdp7/state.hpp"

namespace sightline::machines {

struct InstructionRecord {
  core::Instant time;  // start of its fetch
  core::Instant end;
  pdp7::Address pc;   // its address
  core::Word18 word;  // the word that was fetched
  const pdp7::State& before;
  const pdp7::State& after;
};

struct NoObserver {
  static constexpr bool instructions = false;
  static constexpr bool cycles = false;
  static constexpr bool stops = false;
};

}  // namespace sightline::machines
