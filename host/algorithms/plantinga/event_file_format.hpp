// What writer and reader of event files agree on besides the layout (event_file.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "host/geometry/integer.hpp"

namespace sightline::algorithms::plantinga::event_file {

inline constexpr std::string_view mark = "SIGHTLINE EVENTS\n";
inline constexpr std::uint8_t version = 1;
inline constexpr std::size_t checksum_size = 8;
inline constexpr std::size_t header_size = mark.size() + 1 + 8 + 8;
// Coefficients of events keep below this (direction.hpp).
inline constexpr geometry::Int128 coefficient_limit = geometry::Int128{1} << 104U;

inline std::uint64_t checksum(const std::uint8_t* bytes, std::size_t count) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (std::size_t i = 0; i < count; ++i) hash = (hash ^ bytes[i]) * 1099511628211ULL;
  return hash;
}

}  // namespace sightline::algorithms::plantinga::event_file
