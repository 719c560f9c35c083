// A machine word of fixed width, with DEC's bit numbering.
//
// Word<18> is the word of the PDP-7 and of the Type 340. Arithmetic wraps modulo 2^Bits (two's complement, as TAD and ISZ
// do); one's complement addition is an instruction of the machine and is in its CPU. A word never converts to or from an
// integer implicitly, so that an address, a count and a word cannot be mixed up.
#pragma once

#include <cstdint>

namespace sightline::core {

template <unsigned Bits>
class Word {
  static_assert(Bits >= 1 && Bits <= 31);

 public:
  static constexpr unsigned bits = Bits;
  static constexpr std::uint32_t mask = (std::uint32_t{1} << Bits) - 1;
  static constexpr std::uint32_t sign = std::uint32_t{1} << (Bits - 1);

  constexpr Word() = default;
  // Keeps the low `Bits` bits of value.
  constexpr explicit Word(std::uint32_t value) : value_(value & mask) {}

  [[nodiscard]] constexpr std::uint32_t value() const { return value_; }
  [[nodiscard]] constexpr bool negative() const { return (value_ & sign) != 0; }
  // Value as a two's complement number, -2^(Bits-1) .. 2^(Bits-1)-1.
  [[nodiscard]] constexpr std::int32_t twos_complement() const {
    return static_cast<std::int32_t>(value_) - (negative() ? static_cast<std::int32_t>(mask) + 1 : 0);
  }

  // DEC numbering: bit 0 is the most significant.
  [[nodiscard]] constexpr bool bit(unsigned n) const { return ((value_ >> (Bits - 1 - n)) & 1U) != 0; }
  // Bits first..last (DEC numbering, both included), right-justified.
  [[nodiscard]] constexpr std::uint32_t field(unsigned first, unsigned last) const {
    return (value_ >> (Bits - 1 - last)) & ((std::uint32_t{1} << (last - first + 1)) - 1);
  }

  friend constexpr bool operator==(Word, Word) = default;
  friend constexpr Word operator+(Word a, Word b) { return Word(a.value_ + b.value_); }
  friend constexpr Word operator-(Word a, Word b) { return Word(a.value_ - b.value_); }
  friend constexpr Word operator&(Word a, Word b) { return Word(a.value_ & b.value_); }
  friend constexpr Word operator|(Word a, Word b) { return Word(a.value_ | b.value_); }
  friend constexpr Word operator^(Word a, Word b) { return Word(a.value_ ^ b.value_); }
  constexpr Word operator~() const { return Word(~value_); }

 private:
  std::uint32_t value_ = 0;
};

using Word18 = Word<18>;

}  // namespace sightline::core
