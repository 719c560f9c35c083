// The core memory that a tape or an octal text loads: words at 15-bit addresses, and the start address.
//
// Sparse, because a loader writes only the words of the tape: an absent word keeps the earlier contents of core. A start
// address belongs to the tape (a RIM tape ends with JMP start), not to core; octal text has none.
#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "emulators/core/word.hpp"

namespace sightline::image {

inline constexpr std::uint32_t last_address = 077777;  // 15 bits: 32K words with the Type 148
inline constexpr std::uint32_t field_mask = 017777;    // 13 bits: the address field of an instruction
inline constexpr std::uint32_t bank_mask = 060000;

struct CoreImage {
  std::map<std::uint32_t, core::Word18> words;  // keys 0..last_address
  std::optional<std::uint32_t> start;

  friend bool operator==(const CoreImage&, const CoreImage&) = default;
};

}  // namespace sightline::image
