// Cuts polygons into stripes, as the program does and as a host computer does in its place (SPECIFICATION, section 2).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sightline::programs::stripes {

// The toggles of a line, ascending, below 255; without the final 255.
using Toggles = std::vector<std::uint8_t>;

// The stripes of a face: one list for each line from `low` on.
struct Stripes {
  int low = 0;
  std::vector<Toggles> lines;

  friend bool operator==(const Stripes&, const Stripes&) = default;
};

// A corner in the form of the stream: X and Y in 1/256 dot, Z.
struct Corner {
  std::uint16_t x = 0;
  std::uint16_t y = 0;
  std::uint16_t z = 0;

  [[nodiscard]] int line() const { return (y + 128) >> 8; }
  friend bool operator==(const Corner&, const Corner&) = default;
};
using CornerRings = std::vector<std::vector<Corner>>;

// Section 2, without its limit: a list may be longer than the program can hold; `longest` is the greatest length, including
// intermediate lists.
[[nodiscard]] Stripes stripes_of(const CornerRings& rings, std::size_t& longest);

}  // namespace sightline::programs::stripes
