// The common part of the program of firmware/pdp7/turn and its twin in C++, from its SPECIFICATION.md: the status of a
// picture, and the AC switches.
#pragma once

#include <cstdint>

namespace sightline::programs::turn {

enum class Status : std::uint8_t { right = 0, wrong_sum = 1, file_full = 2, other_tape = 3, reading = 4 };

// AC switches.
inline constexpr std::uint32_t backward_switch = 0400000;
inline constexpr std::uint32_t wire_switch = 0200000;
inline constexpr std::uint32_t single_switch = 0100000;
inline constexpr std::uint32_t speed_mask = 077777;

}  // namespace sightline::programs::turn
