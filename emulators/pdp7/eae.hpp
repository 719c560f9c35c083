// The Type 177 Extended Arithmetic Element: the whole of class 64, as pure functions on {AC, MQ, SC, L}.
//
// Here the step counter counts down to zero; the machine holds its complement and counts up, which OSC shows. Left out:
// time (the caller computes it from `steps`). Event order and commands: EAE instruction list confirmed by three symbol
// tables and by a second simulator's results for 6688 operand sets.
#pragma once

#include <bit>
#include <cstdint>

#include "../core/word.hpp"

namespace sightline::pdp7 {

struct EaeRegisters {
  core::Word18 ac;
  core::Word18 mq;
  core::Word<6> sc;
  bool link = false;

  friend constexpr bool operator==(const EaeRegisters&, const EaeRegisters&) = default;
};

struct EaeResult {
  EaeRegisters registers;
  int steps = 0;  // steps that the counter made; a refused division makes one
};

namespace eae {

inline constexpr std::uint32_t sign_to_link = 0020000;
inline constexpr std::uint32_t clear_mq = 0010000;
inline constexpr std::uint32_t signed_ac = 0004000;
inline constexpr std::uint32_t or_ac_to_mq = 0002000;
inline constexpr std::uint32_t clear_ac = 0001000;
inline constexpr std::uint32_t word_sign = 0400000;
inline constexpr std::uint32_t word_mask = 0777777;

// The counter is decremented before it is tested: a count of 0 means 64 steps.
[[nodiscard]] constexpr int full_count(std::uint32_t count) {
  return count == 0 ? 64 : static_cast<int>(count);
}

// Add and shift right, for each step; in closed form, because MQ holds the multiplier's bits for the first 18 steps from
// the beginning. `product_negative` complements both halves: the 36-bit one's complement of the product.
[[nodiscard]] constexpr EaeResult multiply(EaeRegisters r, std::uint32_t count, std::uint32_t multiplicand,
                                           bool product_negative) {
  std::uint64_t both = (std::uint64_t{r.ac.value()} << 18) | r.mq.value();
  const int steps = full_count(count);
  for (int left = steps; left > 0; left -= 18) {
    const int n = left < 18 ? left : 18;
    const std::uint64_t multiplier = both & ((std::uint64_t{1} << n) - 1);
    both = (both + ((multiplier * multiplicand) << 18)) >> n;
  }
  if (product_negative) both = ~both;
  return {{core::Word18(static_cast<std::uint32_t>(both >> 18)), core::Word18(static_cast<std::uint32_t>(both)),
           core::Word<6>(0), false},
          steps};
}

// Non-restoring division with the remainder corrected at the end: as long as the bits come from MQ, that equals the
// division of AC and the first bits of MQ. If the quotient would not fit, it is refused with L = 1 after the first
// subtraction, so the divisor has already been subtracted from AC.
[[nodiscard]] constexpr EaeResult divide(EaeRegisters r, std::uint32_t count, std::uint32_t divisor,
                                         bool dividend_negative, bool quotient_negative) {
  if (r.ac.value() >= divisor) return {{core::Word18(r.ac.value() - divisor), r.mq, r.sc, true}, 1};
  std::uint32_t ac = r.ac.value();
  std::uint32_t mq = r.mq.value();
  const int steps = full_count(count);
  int left = steps;
  // A step takes the difference of AC and the divisor, then shifts. After 18 steps MQ shifts its quotient in again.
  for (; left > 19; left -= 18) {
    const std::uint64_t dividend = (std::uint64_t{ac} << 18) | mq;
    mq = static_cast<std::uint32_t>((dividend >> 1) / divisor) & word_mask;
    ac = static_cast<std::uint32_t>((dividend >> 1) % divisor << 1 | (dividend & 1U));
  }
  // The last step does not shift.
  const int shifts = left - 1;
  const std::uint64_t dividend = (std::uint64_t{ac} << shifts) | (mq >> (18 - shifts));
  ac = static_cast<std::uint32_t>(dividend % divisor);
  mq = ((mq << left) | static_cast<std::uint32_t>(dividend / divisor)) & word_mask;
  if (dividend_negative) ac = ~ac;
  if (quotient_negative) mq = ~mq;
  return {{core::Word18(ac), core::Word18(mq), core::Word<6>(0), false}, steps};
}

// The 36 bits AC:MQ with 64 copies of L at either side are shifted as one number; counts above 36 change nothing more.
[[nodiscard]] constexpr EaeResult shift_long(EaeRegisters r, std::uint32_t count, bool left) {
  constexpr std::uint64_t both_mask = (std::uint64_t{1} << 36) - 1;
  const std::uint32_t n = count < 36 ? count : 36;
  const std::uint64_t fill = r.link ? both_mask : 0;
  std::uint64_t both = (std::uint64_t{r.ac.value()} << 18) | r.mq.value();
  both = left ? (both << n) | (fill >> (36 - n)) : (both >> n) | (fill << (36 - n));
  r.ac = core::Word18(static_cast<std::uint32_t>((both & both_mask) >> 18));
  r.mq = core::Word18(static_cast<std::uint32_t>(both & word_mask));
  r.sc = core::Word<6>(0);
  return {r, static_cast<int>(count)};
}

// Shift left until bits 0 and 1 of AC differ or the counter has run out; the vacated end is filled with L.
[[nodiscard]] constexpr EaeResult normalize(EaeRegisters r, std::uint32_t count) {
  // AC, MQ and copies of L. The first two bits that differ give the number of shifts: bit 0 or 1 of `changes` is the first
  // that counts.
  const std::uint64_t all = (std::uint64_t{r.ac.value()} << 46) | (std::uint64_t{r.mq.value()} << 28) |
                            (r.link ? (std::uint64_t{1} << 28) - 1 : 0);
  const std::uint64_t changes = (all ^ (all << 1)) >> 1 << 1;
  const int needed = changes == 0 ? 64 : std::countl_zero(changes);
  const int most = full_count(count);
  const int steps = needed < most ? needed : most;
  if (steps == 0) {
    r.sc = core::Word<6>(count);
    return {r, 0};
  }
  EaeResult result = shift_long(r, static_cast<std::uint32_t>(steps), true);
  result.registers.sc = core::Word<6>(count - static_cast<std::uint32_t>(steps));
  return result;
}

[[nodiscard]] constexpr EaeResult shift_ac_left(EaeRegisters r, std::uint32_t count) {
  const std::uint32_t n = count < 18 ? count : 18;
  const std::uint32_t fill = r.link ? word_mask : 0;
  r.ac = core::Word18(static_cast<std::uint32_t>((std::uint64_t{r.ac.value()} << n) | (fill >> (18 - n))));
  r.sc = core::Word<6>(0);
  return {r, static_cast<int>(count)};
}

[[nodiscard]] constexpr EaeResult setup(EaeRegisters r, std::uint32_t word) {
  if ((word & 04U) != 0) r.mq = ~r.mq;
  if ((word & 02U) != 0) r.ac = r.ac | r.mq;
  if ((word & 01U) != 0) r.ac = r.ac | core::Word18((0U - r.sc.value()) & 077U);
  return {r, 0};
}

}  // namespace eae

// Multiply and divide take the word after the instruction as their operand.
[[nodiscard]] constexpr bool eae_takes_operand(std::uint32_t word) {
  const std::uint32_t command = (word >> 6) & 07U;
  return command == 1 || command == 3;
}

// Executes one EAE instruction; `operand` is used only if eae_takes_operand(word).
[[nodiscard]] constexpr EaeResult execute_eae(std::uint32_t word, EaeRegisters r, core::Word18 operand) {
  if ((word & eae::sign_to_link) != 0) r.link = r.ac.negative();
  if ((word & eae::clear_mq) != 0) r.mq = core::Word18(0);
  const bool negative = (word & eae::signed_ac) != 0 && r.ac.negative();
  if ((word & eae::or_ac_to_mq) != 0) {
    r.mq = r.mq | r.ac;
  } else if (negative) {
    r.ac = ~r.ac;
  }
  if ((word & eae::clear_ac) != 0) r.ac = core::Word18(0);

  const std::uint32_t count = word & 077U;
  const bool signs_differ = negative != r.link;
  switch ((word >> 6) & 07U) {
    case 0: return eae::setup(r, word);
    case 1:
      if (negative) r.mq = ~r.mq;
      return eae::multiply(r, count, operand.value(), signs_differ);
    case 3:
      if (negative) r.mq = ~r.mq;
      return eae::divide(r, count, operand.value(), negative, signs_differ);
    case 4: return eae::normalize(r, count);
    case 5: return eae::shift_long(r, count, false);
    case 6: return eae::shift_long(r, count, true);
    case 7: return eae::shift_ac_left(r, count);
    default: return {r, 0};  // command 2 has only the setup events
  }
}

}  // namespace sightline::pdp7
