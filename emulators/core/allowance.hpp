// How long a processor may run before its machine serves a boundary: a time and a number of instructions, packed into one
// host register so that an instruction updates both with one subtraction.
#pragma once

#include <algorithm>
#include <cstdint>

#include "inline.hpp"
#include "time.hpp"

namespace sightline::core {

template <class Tick>
class Allowance {
 public:
  // The most instructions of one allowance. It bounds the depth of the host's stack where a compiler does not turn a call
  // at the end of a function into a jump (threads.hpp).
  static constexpr std::int64_t most = 4095;

  // The machine serves the first boundary later than `left` from now. `instructions`, 0 to `most`, must not exceed the
  // number that can end within that time.
  constexpr Allowance(TickCount<Tick> left, std::int64_t instructions)
      : packed_(left.count() * one_tick + instructions) {}
  explicit constexpr Allowance(std::uint64_t host_word) : packed_(static_cast<std::int64_t>(host_word)) {}
  [[nodiscard]] constexpr std::uint64_t host_word() const { return static_cast<std::uint64_t>(packed_); }

  SIGHTLINE_INLINE constexpr void pass(TickCount<Tick> time) { packed_ -= time.count() * one_tick; }
  SIGHTLINE_INLINE constexpr void count_instruction() { --packed_; }
  [[nodiscard]] SIGHTLINE_INLINE constexpr bool over() const { return packed_ < 0; }
  // The machine serves the next boundary.
  constexpr void end() { packed_ = instructions() - one_tick; }

  // Negative once the time has been exceeded, by that much.
  [[nodiscard]] constexpr TickCount<Tick> left() const { return TickCount<Tick>(packed_ >> bits); }
  [[nodiscard]] constexpr std::int64_t instructions() const { return packed_ & (one_tick - 1); }

 private:
  static constexpr unsigned bits = 12;
  static constexpr std::int64_t one_tick = std::int64_t{1} << bits;
  static_assert(most == one_tick - 1);

  std::int64_t packed_;
};

}  // namespace sightline::core
