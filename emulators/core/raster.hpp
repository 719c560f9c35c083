// The image memory of a raster board: 256 by 256 points of eight colours, one byte per point.
//
// y counts UP, as on the boards and on paper: at(0, 0) is the lower left point. The bottom row comes first in memory, each
// row from left to right, so a writer of image files that begin with the top row reads the rows backwards. A point is 0
// (background) to 7; on a colour monitor bit 2 is red, bit 1 green, bit 0 blue, on a grey one the number is the brightness.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "state_visitor.hpp"

namespace sightline::core {

class Raster {
 public:
  static constexpr int width = 256;
  static constexpr int height = 256;
  static constexpr std::size_t size = std::size_t{width} * height;

  // x from the left and y from the bottom, both 0..255.
  [[nodiscard]] constexpr std::uint8_t at(std::uint8_t x, std::uint8_t y) const {
    return points_[index(x, y)];
  }
  constexpr void set(std::uint8_t x, std::uint8_t y, std::uint8_t value) { points_[index(x, y)] = value; }
  constexpr void fill(std::uint8_t value) { points_.fill(value); }

  // All points, bottom row first.
  [[nodiscard]] constexpr std::span<const std::uint8_t, size> points() const { return points_; }
  // Row y from the left.
  [[nodiscard]] constexpr std::span<const std::uint8_t, width> row(std::uint8_t y) const {
    return std::span<const std::uint8_t, width>(&points_[index(0, y)], width);
  }

  void visit_state(core::StateVisitor& visit) {
    visit.bytes("points", std::span<std::uint8_t>(points_), 7);
  }

  friend constexpr bool operator==(const Raster&, const Raster&) = default;

 private:
  static constexpr std::size_t index(std::uint8_t x, std::uint8_t y) { return std::size_t{y} * width + x; }

  std::array<std::uint8_t, size> points_{};
};

}  // namespace sightline::core
