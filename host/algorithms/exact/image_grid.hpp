// Finds the occluders near a part of the image: a grid of cells over the image raster. Each cell lists its occluders,
// nearest first.
#pragma once

#include <algorithm>
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
    std::array<std::uint32_t, 2> high{};  // inclusive
  };

  // The occluders of a cell, nearest first. The bounds of an occluder are four packed numbers of 15 bits, the high ends
  // stored as the distance from the last step, so that one subtraction compares all four with a rectangle. An occluder's
  // rank is its position among all occluders ordered by depth.
  struct Entries {
    std::span<const std::uint64_t> bounds;
    std::span<const std::uint32_t> ranks;

    [[nodiscard]] std::size_t size() const { return ranks.size(); }
  };

  // Tells which entries of a cell may overlap a rectangle.
  class Query {
   public:
    Query(const ImageGrid& grid, const ImageBounds& bounds) : grid_(grid), cells_(grid.cells_of(bounds)) {
      around_ = packed({bounds.high[0], bounds.high[1], last_minus(bounds.low[0]), last_minus(bounds.low[1])}) | guards;
    }

    [[nodiscard]] const Cells& cells() const { return cells_; }
    // Selects the cell of the entries passed next.
    void enter(std::uint32_t column, std::uint32_t row) {
      first_ = packed({column > cells_.low[0] ? grid_.first_step(column) : std::uint64_t{0},
                       row > cells_.low[1] ? grid_.first_step(row) : std::uint64_t{0}, 0, 0});
    }
    // The occluder touches the rectangle, and this cell is the first, by rows, that contains parts of both. Therefore an
    // occluder passes in only one of its cells.
    [[nodiscard]] bool passes(std::uint64_t entry_bounds) const {
      return ((around_ - entry_bounds) & ((entry_bounds | guards) - first_) & guards) == guards;
    }

   private:
    const ImageGrid& grid_;
    Cells cells_;
    std::uint64_t around_ = 0;
    std::uint64_t first_ = 0;
  };

  // `bounds` and `depths` are indexed by occluder. Uses up to `jobs` threads.
  ImageGrid(std::span<const ImageBounds> bounds, std::span<const std::uint32_t> depths, unsigned jobs = 1);

  [[nodiscard]] std::uint32_t side() const { return side_; }  // cells per row and per column
  [[nodiscard]] Cells cells_of(const ImageBounds& bounds) const {
    return {{cell_of(bounds.low[0]), cell_of(bounds.low[1])}, {cell_of(bounds.high[0]), cell_of(bounds.high[1])}};
  }
  [[nodiscard]] Entries entries_at(std::uint32_t column, std::uint32_t row) const {
    const std::size_t cell = std::size_t{row} * side_ + column;
    const std::size_t count = starts_[cell + 1] - starts_[cell];
    return {{bounds_.data() + starts_[cell], count}, {ranks_.data() + starts_[cell], count}};
  }

  [[nodiscard]] std::uint32_t occluder(std::uint32_t rank) const { return order_[rank]; }
  // The number of occluders with a depth up to this one, which are those of the lowest ranks.
  [[nodiscard]] std::uint32_t count_up_to(std::uint32_t depth) const {
    if (depths_.empty() || depth < depths_.front()) return 0;
    const std::size_t bucket = std::min<std::size_t>((depth - depths_.front()) >> bucket_shift_, buckets_.size() - 2);
    const auto begin = depths_.begin() + static_cast<std::ptrdiff_t>(buckets_[bucket]);
    const auto end = depths_.begin() + static_cast<std::ptrdiff_t>(buckets_[bucket + 1]);
    return static_cast<std::uint32_t>(std::upper_bound(begin, end, depth) - depths_.begin());
  }

 private:
  // The highest bit of each of the four numbers: it stays set where the difference is not negative.
  static constexpr std::uint64_t guards = 0x8000800080008000U;

  [[nodiscard]] static std::uint64_t last_minus(std::uint16_t step) { return std::uint64_t{last_step} - step; }
  [[nodiscard]] static std::uint64_t packed(const std::array<std::uint64_t, 4>& numbers) {
    return numbers[0] | numbers[1] << 16 | numbers[2] << 32 | numbers[3] << 48;
  }
  [[nodiscard]] std::uint32_t cell_of(std::uint16_t step) const { return (step * side_) >> 15; }
  [[nodiscard]] std::uint64_t first_step(std::uint32_t cell) const { return first_steps_[cell]; }
  [[nodiscard]] std::uint64_t entries_needed(std::span<const ImageBounds> bounds) const;  // for the current number of cells
  void sort_by_depth(std::span<const std::uint32_t> depths, unsigned jobs);

  std::uint32_t side_ = 1;
  std::vector<std::uint16_t> first_steps_;  // of each column, and each row
  std::vector<std::uint32_t> starts_;
  std::vector<std::uint64_t> bounds_;  // of the entries of all cells
  std::vector<std::uint32_t> ranks_;
  std::vector<std::uint32_t> order_;    // the occluder of each rank
  std::vector<std::uint32_t> depths_;   // of each rank
  std::vector<std::uint32_t> buckets_;  // first rank whose depth exceeds the least depth by each multiple of 2^bucket_shift_
  unsigned bucket_shift_ = 0;
};

}  // namespace sightline::algorithms::exact
