// All times of the EF9365 board.
//
// The chip's clock is 1.75 MHz; 112 of its periods make a line of 64 us. The data sheet is not available: values marked
// "chosen" are plausible for a board of the time, and measured times of programs depend on them.
#pragma once

#include <cstdint>

#include "../core/time.hpp"

namespace sightline::devices::ef9365 {

// 4000/7 ns per period; the end of the last one is rounded up.
[[nodiscard]] constexpr core::Duration clocks(std::int64_t n) {
  return core::Duration((n * 4000 + 6) / 7);
}

// A vector or a symbol: one period per dot scanned, lit or not, and one to start (chosen; about a million dots per second
// is documented).
inline constexpr std::int64_t start_up_clocks = 1;
// Commands that only set a register (from another emulator, which marks the figure as unchecked).
inline constexpr std::int64_t register_command_clocks = 4;
// Direct memory access waits for a free cycle (same source).
inline constexpr std::int64_t memory_access_clocks = 64;
// Clearing and filling sweep the screen with the display: two fields (chosen).
inline constexpr core::Duration sweep{40'000'000};

inline constexpr core::Duration line{64'000};
inline constexpr core::Duration field = line * 312;      // 50.08 Hz, not interlaced
inline constexpr core::Duration displayed = line * 256;  // then vertical blanking, to the end of the field

static_assert(clocks(112) == line);

}  // namespace sightline::devices::ef9365
