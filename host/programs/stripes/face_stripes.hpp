// Polygons cut into stripes, as the program does it and a host computer that does it instead (SPECIFICATION, section 2).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sightline::programs::stripes {

// Toggles of a line, ascending, below 255; without the 255 at the end.
using Toggles = std::vector<std::uint8_t>;

// The stripes of a face: lists from line `low` on.
struct Stripes {
  int low = 0;
  std::vector<Toggles> lines;

  friend bool operator==(const Stripes&, const Stripes&) = default;
};

// A corner as the stream has it: X and Y in 1/256 dot, Z.
struct Corner {
  std::uint16_t x = 0;
  std::uint16_t y = 0;
  std::uint16_t z = 0;

  [[nodiscard]] int line() const { return (y + 128) >> 8; }
  friend bool operator==(const Corner&, const Corner&) = default;
};
using CornerRings = std::vector<std::vector<Corner>>;

// Section 2, without its limit: a list may be longer than the program can hold, and `longest` says how long one was, also in between.
[[nodiscard]] Stripes stripes_of(const CornerRings& rings, std::size_t& longest);

}  // namespace sightline::programs::stripes
