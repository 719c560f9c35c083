// The operate class (74xxxx): several microinstructions in one word, in a fixed order of events.
//
// Order (PDP-4 manual page 58): the skip is decided on the old AC and L; CLA, CLL; CMA, CML; OAS; rotate; HLT at the end of
// the cycle. The PDP-4 manual calls rotating together with CMA, CML or OAS illegal; here, as on another simulator, the
// order above decides. RAL with RAR is undefined on the machine and rotates nothing.
#pragma once

#include <array>
#include <cstdint>

#include "../core/inline.hpp"
#include "../core/word.hpp"

namespace sightline::pdp7 {

namespace operate_bits {
inline constexpr std::uint32_t cma = 01, cml = 02, oas = 04, ral = 010, rar = 020, hlt = 040, sma = 0100,
                               sza = 0200, snl = 0400, invert = 01000, twice = 02000, cll = 04000,
                               cla = 010000;
}

// L,AC as 19 bits, one place to the left or right.
[[nodiscard]] constexpr std::uint32_t rotate_left(std::uint32_t lac) {
  return ((lac << 1) | (lac >> 18)) & 01777777U;
}
[[nodiscard]] constexpr std::uint32_t rotate_right(std::uint32_t lac) {
  return ((lac >> 1) | (lac << 18)) & 01777777U;
}

namespace detail {

inline constexpr std::uint32_t link_bit = core::Word18::mask + 1;

// The bits that CLL and CLA keep, and those that CMA and CML complement.
inline constexpr std::array<std::uint32_t, 4> kept{link_bit | core::Word18::mask, core::Word18::mask, link_bit, 0};
inline constexpr std::array<std::uint32_t, 4> complemented{0, core::Word18::mask, link_bit,
                                                           link_bit | core::Word18::mask};
static_assert(operate_bits::cla == operate_bits::cll << 1 && operate_bits::cma == 1 && operate_bits::cml == 2);

}  // namespace detail

// The result of an OPR on L,AC as 19 bits.
struct OperatedBits {
  std::uint32_t lac;
  bool skip;
};

// Everything but HLT; `switches` are the AC switches, read only by OAS. The skip is decided first: the OR of the chosen
// conditions, inverted by bit 8. The code branches once for each group of microinstructions, not for each bit, because all
// OPRs of a program share it.
[[nodiscard]] SIGHTLINE_INLINE constexpr OperatedBits operate_on_bits(std::uint32_t word, std::uint32_t lac,
                                                                            core::Word18 switches) {
  using namespace operate_bits;
  OperatedBits result{lac, false};
  if ((word & (sma | sza | snl | invert)) != 0) {
    const std::uint32_t ac = lac & core::Word18::mask;
    const std::uint32_t conditions = (lac >> 11 & sma) | (lac >> 10 & snl) | (ac == 0 ? sza : 0U);
    result.skip = ((conditions & word) != 0) != ((word & invert) != 0);
  }
  if ((word & (cla | cll | cma | cml)) != 0)
    result.lac = (lac & detail::kept[(word / cll) & 3U]) ^ detail::complemented[word & 3U];
  if ((word & (oas | ral | rar)) != 0) {
    if ((word & oas) != 0) result.lac |= switches.value();
    const std::uint32_t direction = word & (ral | rar);
    result.lac &= detail::link_bit | core::Word18::mask;
    if (direction == ral) {
      result.lac = rotate_left(result.lac);
      if ((word & twice) != 0) result.lac = rotate_left(result.lac);
    } else if (direction == rar) {
      result.lac = rotate_right(result.lac);
      if ((word & twice) != 0) result.lac = rotate_right(result.lac);
    }
  }
  return result;
}

}  // namespace sightline::pdp7
