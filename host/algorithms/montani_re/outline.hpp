// The corners of a face and the lines through its edges, four side by side: which corners are on which side of which lines
// is told without a branch for each of them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "host/algorithms/montani_re/image.hpp"

namespace sightline::algorithms::montani_re {

// Up to four corners and four lines of one face; where there are fewer, the last is repeated.
struct OutlineQuad {
  std::array<double, 4> x{};  // a vertex as in Image
  std::array<double, 4> y{};
  std::array<double, 4> weight{};
  // Lines: a x + b y + c weight, turned by what the sides of the lines are multiplied by.
  std::array<double, 4> a{};
  std::array<double, 4> b{};
  std::array<double, 4> c{};
  std::array<double, 4> error{};  // of that sum, for any vertex

  void set_corner(std::size_t k, const Image& image, std::uint32_t vertex);
  void set_line(std::size_t k, const Image& image, std::uint32_t line, double turned);
};

// Of each of four lines, as bits, what is certain of corners.
struct LineSides {
  unsigned any_inside = 0;  // the sum is positive for some corner
  unsigned any_outside = 0;
  unsigned all_outside = 0;
};
[[nodiscard]] LineSides sides_of_lines(const OutlineQuad& lines, std::span<const OutlineQuad> corners);

}  // namespace sightline::algorithms::montani_re
