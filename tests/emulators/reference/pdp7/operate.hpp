// The operate class (74xxxx): several microinstructions in one word, in a fixed order of events.
//
// Order (PDP-4 manual page 58): the skip is decided on AC and L as they were; CLA, CLL; CMA, CML; OAS;
// rotate; HLT at the end of the cycle. The PDP-4 manual calls rotating together with CMA, CML or OAS illegal;
// here, as on another simulator, the order above decides. RAL with RAR is undefined on the machine and
// rotates nothing.
#pragma once

#include <cstdint>

#include "emulators/core/word.hpp"

namespace sightline::reference {
using namespace pdp7;


struct Operated {
  core::Word18 ac;
  bool link = false;
  bool skip = false;
};

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

// Whether the skip microinstructions of `word` skip: the OR of the chosen conditions, inverted by bit 8.
[[nodiscard]] constexpr bool operate_skips(std::uint32_t word, core::Word18 ac, bool link) {
  using namespace operate_bits;
  const bool any = ((word & sma) != 0 && ac.negative()) || ((word & sza) != 0 && ac.value() == 0) ||
                   ((word & snl) != 0 && link);
  return any != ((word & invert) != 0);
}

// Everything but HLT; `switches` are the AC switches, read only by OAS.
[[nodiscard]] constexpr Operated operate(std::uint32_t word, core::Word18 ac, bool link,
                                         core::Word18 switches) {
  using namespace operate_bits;
  Operated result{ac, link, operate_skips(word, ac, link)};
  if ((word & cla) != 0) result.ac = core::Word18(0);
  if ((word & cll) != 0) result.link = false;
  if ((word & cma) != 0) result.ac = ~result.ac;
  if ((word & cml) != 0) result.link = !result.link;
  if ((word & oas) != 0) result.ac = result.ac | switches;
  const std::uint32_t direction = word & (ral | rar);
  if (direction == ral || direction == rar) {
    std::uint32_t lac = (result.link ? 01000000U : 0U) | result.ac.value();
    const int places = (word & twice) != 0 ? 2 : 1;
    for (int i = 0; i < places; ++i) lac = direction == ral ? rotate_left(lac) : rotate_right(lac);
    result.ac = core::Word18(lac);
    result.link = lac > core::Word18::mask;
  }
  return result;
}

}  // namespace sightline::reference
