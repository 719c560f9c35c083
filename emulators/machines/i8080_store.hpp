// The memory of an 8080, and behind it what its runs need while an observer looks at marked places or at registers: in one piece, so
// that one host register leads to all of it. Without such an observer nothing but the bytes is touched. Nobody but those runs sees the
// rest, and no snapshot holds it: it is made from what the observer says.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "../i8080/state.hpp"

namespace sightline::machines {

struct I8080Store {
  static constexpr std::size_t size = 65536;
  static constexpr std::size_t codes = 256;
  // Marks of an address: a byte that is none of an instruction is read from it, or written there.
  static constexpr std::uint8_t is_read = 2, is_written = 4;

  std::array<i8080::Byte, size> bytes;
  // What executes an opcode, and behind all of them the same for marked addresses.
  std::array<void (*)(), 2 * codes> functions;
  // What follows an instruction that may have changed what the observer looks at; the second if it also writes to memory.
  std::array<void (*)(), 2> tests;
  // A byte and its marks do not share the last bits of their addresses, by which hosts tell whether a load waits for a store.
  std::array<std::uint8_t, 2112> apart;
  // By values of registers: 1 until the observer has said that it waits for others.
  std::array<std::uint8_t, size> doubts;
  // Marks; the first again behind the last, for two that are compared at once.
  std::array<std::uint8_t, size + 1> accesses;
  // `codes` where a run is asked before an instruction, else 0: with one OR an opcode becomes an index of `functions`.
  std::array<std::uint32_t, size> places;
};

}  // namespace sightline::machines
