// Finds the occluders near a part of the image: a grid of cells over its raster, each with its occluders, the nearest
// first.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/algorithms/exact/view.hpp"

namespace sightline::algorithms::exact {

class ImageGrid {
 public:
  struct Cells {
    std::array<std::uint32_t, 2> low{};
    std::array<std::uint32_t, 2> high{};  // included
  };

  // An occluder in a cell. Its bounds are four numbers of 15 bits, those of the high ends counted from the last step, so
  // that one subtraction of all four compares them with a rectangle.
  struct Entry {
    std::uint64_t bounds = 0;
    std::uint32_t depth = 0;
    std::uint32_t occluder = 0;
  };

  // Which entries of a cell may matter for a rectangle.
  class Query {
   public:
    Query(const ImageGrid& grid, const ImageBounds& bounds) : grid_(grid), cells_(grid.cells_of(bounds)) {
      around_ = packed({bounds.high[0], bounds.high[1], last_minus(bounds.low[0]), last_minus(bounds.low[1])}) | guards;
    }

    [[nodiscard]] const Cells& cells() const { return cells_; }
    // The entries after this are those of another cell.
    void enter(std::uint32_t column, std::uint32_t row) {
      first_ = packed({column > cells_.low[0] ? grid_.first_step(column) : std::uint64_t{0},
                       row > cells_.low[1] ? grid_.first_step(row) : std::uint64_t{0}, 0, 0});
    }
    // It touches the rectangle, and this is the first of the cells that both are in, by rows: an occluder passes in
    // one of its cells.
    [[nodiscard]] bool passes(const Entry& entry) const {
      return ((around_ - entry.bounds) & ((entry.bounds | guards) - first_) & guards) == guards;
    }

   private:
    const ImageGrid& grid_;
    Cells cells_;
    std::uint64_t around_ = 0;
    std::uint64_t first_ = 0;
  };

  // Of occluders with these bounds and depths, numbered from 0. On so many threads.
  ImageGrid(std::span<const ImageBounds> bounds, std::span<const std::uint32_t> depths, unsigned jobs = 1);

  [[nodiscard]] std::uint32_t side() const { return side_; }  // cells in a row and in a column
  [[nodiscard]] Cells cells_of(const ImageBounds& bounds) const {
    return {{cell_of(bounds.low[0]), cell_of(bounds.low[1])}, {cell_of(bounds.high[0]), cell_of(bounds.high[1])}};
  }
  [[nodiscard]] std::span<const Entry> entries_at(std::uint32_t column, std::uint32_t row) const {
    const std::size_t cell = std::size_t{row} * side_ + column;
    return {entries_.data() + starts_[cell], entries_.data() + starts_[cell + 1]};
  }

 private:
  // The highest bit of each of the four numbers: it stays where the difference is not negative.
  static constexpr std::uint64_t guards = 0x8000800080008000U;

  [[nodiscard]] static std::uint64_t last_minus(std::uint16_t step) { return std::uint64_t{last_step} - step; }
  [[nodiscard]] static std::uint64_t packed(const std::array<std::uint64_t, 4>& numbers) {
    return numbers[0] | numbers[1] << 16 | numbers[2] << 32 | numbers[3] << 48;
  }
  [[nodiscard]] std::uint32_t cell_of(std::uint16_t step) const { return (step * side_) >> 15; }
  [[nodiscard]] std::uint64_t first_step(std::uint32_t cell) const { return first_steps_[cell]; }
  [[nodiscard]] std::uint64_t entries_needed(std::span<const ImageBounds> bounds) const;  // with the cells as they are

  std::uint32_t side_ = 1;
  std::vector<std::uint16_t> first_steps_;  // of each column, and each row
  std::vector<std::uint32_t> starts_;
  std::vector<Entry> entries_;
};

}  // namespace sightline::algorithms::exact
