// CRC-32 as in PNG, gzip and Ethernet: polynomial 04C11DB7 reflected, initial value and final inversion
// FFFFFFFF.
#pragma once

#include <cstdint>
#include <span>

namespace sightline::base {

[[nodiscard]] std::uint32_t crc32(std::span<const std::uint8_t> bytes);

}  // namespace sightline::base
