// Finds the occluders near a part of the image: a grid of cells over it, each with its occluders in the
// order given. A point outside the grid belongs to the nearest border cell.
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

  explicit ImageGrid(const View& view);

  [[nodiscard]] Cells cells_of(const ImageBounds& bounds) const;
  [[nodiscard]] std::span<const std::uint32_t> occluders_at(std::uint32_t column, std::uint32_t row) const {
    const std::size_t cell = std::size_t{row} * side_ + column;
    return {entries_.data() + starts_[cell], entries_.data() + starts_[cell + 1]};
  }

 private:
  void fit(const View& view);
  [[nodiscard]] std::uint64_t entries_needed(const View& view) const;  // with the cells as they are

  std::uint32_t side_ = 1;  // cells in a row and in a column
  std::array<double, 2> origin_{};
  std::array<double, 2> cells_a_unit_{1, 1};
  std::vector<std::uint32_t> starts_;
  std::vector<std::uint32_t> entries_;
};

}  // namespace sightline::algorithms::exact
