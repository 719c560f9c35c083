#include "host/base/crc32.hpp"

#include <array>
#include <cstddef>

namespace sightline::base {

namespace {

// tables[k][b]: the remainder of byte b followed by k zero bytes; eight bytes are one step.
using Tables = std::array<std::array<std::uint32_t, 256>, 8>;

constexpr Tables make_tables() {
  Tables tables{};
  for (std::uint32_t b = 0; b < 256; ++b) {
    std::uint32_t remainder = b;
    for (int bit = 0; bit < 8; ++bit)
      remainder = (remainder & 1U) != 0 ? 0xEDB88320U ^ (remainder >> 1) : remainder >> 1;
    tables[0][b] = remainder;
  }
  for (std::size_t k = 1; k < tables.size(); ++k) {
    for (std::size_t b = 0; b < 256; ++b)
      tables[k][b] = (tables[k - 1][b] >> 8) ^ tables[0][tables[k - 1][b] & 0xFFU];
  }
  return tables;
}

constexpr Tables tables = make_tables();

}  // namespace

std::uint32_t crc32(std::span<const std::uint8_t> bytes) {
  std::uint32_t crc = 0xFFFFFFFFU;
  std::size_t at = 0;
  for (; bytes.size() - at >= 8; at += 8) {
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < 8; ++i)
      next ^= tables[7 - i][bytes[at + i] ^ (i < 4 ? crc >> (8 * i) & 0xFFU : 0U)];
    crc = next;
  }
  for (; at < bytes.size(); ++at) crc = tables[0][(crc ^ bytes[at]) & 0xFFU] ^ (crc >> 8);
  return ~crc;
}

}  // namespace sightline::base
