// Bits of the word that IORS reads. Bit 0, interrupts on, belongs to the processor; the EAE step counter is left out
// (unknown).
#pragma once

#include <cstdint>

namespace sightline::pdp7::status {

inline constexpr std::uint32_t reader = 0200000, punch = 0100000, keyboard = 0040000, printer = 0020000, light_pen = 0010000,
                               clock = 0004000, clock_on = 0002000;

}  // namespace sightline::pdp7::status
