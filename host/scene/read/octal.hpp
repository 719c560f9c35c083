// An 18-bit word as DEC's assembler and listings write it.
#pragma once

#include <cstdint>
#include <string>

namespace sightline::scene {

// Six octal digits.
[[nodiscard]] inline std::string octal(std::uint32_t word) {
  std::string digits(6, '0');
  for (int d = 5; d >= 0; --d, word >>= 3)
    digits[static_cast<std::size_t>(d)] = static_cast<char>('0' + (word & 07U));
  return digits;
}

}  // namespace sightline::scene
