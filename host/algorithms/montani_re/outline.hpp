// The corners of a face and the lines through its edges in groups of four, so that the sides of all lines on which
// corners are can be tested without branches.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "host/algorithms/montani_re/image.hpp"

namespace sightline::algorithms::montani_re {

// Up to four corners and four lines of one face; if there are fewer, the last is repeated.
struct OutlineQuad {
  std::array<double, 4> x{};  // vertices as in Image
  std::array<double, 4> y{};
  std::array<double, 4> weight{};
  // Lines: a x + b y + c weight, multiplied by the sign of the side on which the face is.
  std::array<double, 4> a{};
  std::array<double, 4> b{};
  std::array<double, 4> c{};
  std::array<double, 4> error{};  // bound of the error of that sum, for any vertex

  void set_corner(std::size_t k, const Image& image, std::uint32_t vertex);
  void set_line(std::size_t k, const Image& image, std::uint32_t line, double turned);
};

// What is certain about the corners, as one bit for each of four lines.
struct LineSides {
  unsigned any_inside = 0;  // the sum is positive at some corner
  unsigned any_outside = 0;
  unsigned all_outside = 0;
};
[[nodiscard]] LineSides sides_of_lines(const OutlineQuad& lines, std::span<const OutlineQuad> corners);

}  // namespace sightline::algorithms::montani_re
