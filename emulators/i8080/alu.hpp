// The effect of the 8080's arithmetic and logic on the accumulator and on F (S Z 0 AC 0 P 1 CY).
//
// Source: Intel MCS-80 User's Manual, chapter 4; where it is silent (AC of the logical operations and of DAA, the constant
// bits of F) measurements on the gate-level model of the KR580VM80A. Not modelled: the NEC uPD8080A, without these constant
// bits, and AMD's Am9080A, whose AC differs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "../core/inline.hpp"
#include "isa.hpp"
#include "state.hpp"

namespace sightline::i8080 {

struct Result {
  Byte value;
  Byte flags;  // the whole of F
};

namespace detail {

// S, Z and P of every byte, and the constant 1 bit. P is even parity.
inline constexpr auto sign_zero_parity = [] {
  std::array<Byte, 256> table{};
  for (unsigned value = 0; value < 256; ++value) {
    unsigned ones = 0;
    for (unsigned bits = value; bits != 0; bits >>= 1) ones += bits & 1U;
    table[value] = static_cast<Byte>((value & flag::sign) | (value == 0 ? flag::zero : 0) |
                                     (ones % 2 == 0 ? flag::parity : 0) | flag::always_one);
  }
  return table;
}();

// The same for a sum of nine bits, whose highest is CY.
inline constexpr auto sign_zero_parity_carry = [] {
  std::array<Byte, 512> table{};
  for (unsigned sum = 0; sum < 512; ++sum) table[sum] = static_cast<Byte>(sign_zero_parity[sum % 256] | sum >> 8);
  return table;
}();

// F after INR or DCR gave a byte, without CY: AC is 1 where the low digit became 0 (INR), or did not become F (DCR).
inline constexpr auto flags_after_increment = [] {
  std::array<Byte, 256> table = sign_zero_parity;
  for (unsigned value = 0; value < 256; value += 16) table[value] |= flag::auxiliary;
  return table;
}();
inline constexpr auto flags_after_decrement = [] {
  std::array<Byte, 256> table = sign_zero_parity;
  for (unsigned value = 0; value < 256; ++value) table[value] |= value % 16 != 15 ? flag::auxiliary : Byte{0};
  return table;
}();

}  // namespace detail

// a + operand + carry (0 or 1). AC is the carry out of bit 3.
[[nodiscard]] SIGHTLINE_INLINE constexpr Result add(Byte a, Byte operand, unsigned carry) {
  const unsigned sum = a + operand + carry;
  const unsigned carries = a ^ operand ^ sum;  // bit n: the carry into bit n
  return {static_cast<Byte>(sum), static_cast<Byte>(detail::sign_zero_parity_carry[sum] | (carries & flag::auxiliary))};
}

// a - operand - borrow (0 or 1). The machine adds the complement: AC is the carry of that sum, so 1 means that the low
// digit did not borrow, while CY is inverted and means a borrow.
[[nodiscard]] SIGHTLINE_INLINE constexpr Result subtract(Byte a, Byte operand, unsigned borrow) {
  const unsigned difference = static_cast<unsigned>(a) - operand - borrow;
  const unsigned borrows = a ^ operand ^ difference;
  return {static_cast<Byte>(difference),
          static_cast<Byte>(detail::sign_zero_parity_carry[difference & 0x1FFU] | (~borrows & flag::auxiliary))};
}

// AC is the OR of bit 3 of the operands: the state of the adder's carry chain during an AND.
[[nodiscard]] SIGHTLINE_INLINE constexpr Result and_(Byte a, Byte operand) {
  const Byte value = a & operand;
  return {value, static_cast<Byte>(detail::sign_zero_parity[value] | ((a | operand) << 1 & flag::auxiliary))};
}
[[nodiscard]] SIGHTLINE_INLINE constexpr Result exclusive_or(Byte a, Byte operand) {
  const Byte value = a ^ operand;
  return {value, detail::sign_zero_parity[value]};
}
[[nodiscard]] SIGHTLINE_INLINE constexpr Result or_(Byte a, Byte operand) {
  const Byte value = a | operand;
  return {value, detail::sign_zero_parity[value]};
}

// INR and DCR do not change CY.
[[nodiscard]] SIGHTLINE_INLINE constexpr Result increment(Byte value, Byte flags) {
  const Byte result = static_cast<Byte>(value + 1);
  return {result, static_cast<Byte>(detail::flags_after_increment[result] | (flags & flag::carry))};
}
[[nodiscard]] SIGHTLINE_INLINE constexpr Result decrement(Byte value, Byte flags) {
  const Byte result = static_cast<Byte>(value - 1);
  return {result, static_cast<Byte>(detail::flags_after_decrement[result] | (flags & flag::carry))};
}

// DAA corrects a sum of two packed decimal numbers; it cannot correct a difference. It sets CY but never clears it.
[[nodiscard]] constexpr Result decimal_adjust(Byte a, Byte flags) {
  const bool low_digit = (flags & flag::auxiliary) != 0 || (a & 0x0FU) > 9;
  const bool high_digit = (flags & flag::carry) != 0 || a > 0x99;
  Result result = add(a, static_cast<Byte>((low_digit ? 0x06 : 0) | (high_digit ? 0x60 : 0)), 0);
  result.flags = static_cast<Byte>((result.flags & ~flag::carry) | (high_digit ? flag::carry : 0));
  return result;
}

// RLC, RRC, RAL and RAR change CY only.
[[nodiscard]] constexpr Byte with_carry(Byte flags, unsigned carry) {
  return static_cast<Byte>((flags & ~flag::carry) | carry);
}
[[nodiscard]] constexpr Result rotate_left(Byte a, Byte flags, unsigned into_bit_0) {
  return {static_cast<Byte>(static_cast<unsigned>(a) << 1 | into_bit_0), with_carry(flags, a >> 7U)};
}
[[nodiscard]] constexpr Result rotate_right(Byte a, Byte flags, unsigned into_bit_7) {
  return {static_cast<Byte>(static_cast<unsigned>(a) >> 1 | into_bit_7 << 7), with_carry(flags, a & 1U)};
}

// One of RLC to CMP (except CMA, STC and CMC) on the accumulator; those with no operand ignore `operand`.
template <Operation O>
[[nodiscard]] SIGHTLINE_INLINE constexpr Result operate(Byte a, Byte operand, Byte f) {
  const unsigned carry = f & flag::carry;
  switch (O) {
    case Operation::rlc: return rotate_left(a, f, a >> 7);
    case Operation::ral: return rotate_left(a, f, carry);
    case Operation::rrc: return rotate_right(a, f, a & 1U);
    case Operation::rar: return rotate_right(a, f, carry);
    case Operation::daa: return decimal_adjust(a, f);
    case Operation::add: return add(a, operand, 0);
    case Operation::adc: return add(a, operand, carry);
    case Operation::sbb: return subtract(a, operand, carry);
    case Operation::ana: return and_(a, operand);
    case Operation::xra: return exclusive_or(a, operand);
    case Operation::ora: return or_(a, operand);
    default: return subtract(a, operand, 0);
  }
}

// The condition in bits 5-3 of a jump, call or return: NZ Z NC C PO PE P M.
[[nodiscard]] SIGHTLINE_INLINE constexpr bool holds(unsigned condition, Byte flags) {
  constexpr std::array<Byte, 4> tested{flag::zero, flag::carry, flag::parity, flag::sign};
  return ((flags & tested[condition >> 1]) != 0) == ((condition & 1U) != 0);
}

}  // namespace sightline::i8080
