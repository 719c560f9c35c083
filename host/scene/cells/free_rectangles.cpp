// See free_rectangles.hpp.
#include "host/scene/cells/free_rectangles.hpp"

#include <algorithm>

namespace sightline::scene {

using geometry::Rectangle;
using geometry::Span;

bool FreeRectangles::find(const Rectangle& whole, std::span<const Rectangle> covers, std::size_t most_parts) {
  free_.clear();
  if (!lay_out(whole, covers, most_parts)) return false;
  for (const Rectangle& rectangle : covers) cover(rectangle);
  take_rectangles(whole);
  return true;
}

bool FreeRectangles::lay_out(const Rectangle& whole, std::span<const Rectangle> covers,
                             std::size_t most_parts) {
  for (std::size_t k = 0; k < 2; ++k) {
    borders_[k] = {whole.sides[k].low, whole.sides[k].high};
    for (const Rectangle& rectangle : covers) {
      for (const std::int32_t c : {rectangle.sides[k].low, rectangle.sides[k].high})
        if (whole.sides[k].contains(c)) borders_[k].push_back(c);
    }
    std::sort(borders_[k].begin(), borders_[k].end());
    borders_[k].erase(std::unique(borders_[k].begin(), borders_[k].end()), borders_[k].end());
  }
  const std::size_t columns = borders_[0].size() - 1;
  const std::size_t rows = borders_[1].size() - 1;
  if (columns > most_parts / rows) return false;
  covered_.assign(columns * rows, 0);
  return true;
}

// Clipped to the whole; its sides, where they lie within, are borders.
void FreeRectangles::cover(const Rectangle& rectangle) {
  std::array<std::size_t, 2> low{};
  std::array<std::size_t, 2> end{};
  for (std::size_t k = 0; k < 2; ++k) {
    const auto number_of = [&](std::int32_t c) {
      const std::int32_t within = std::clamp(c, borders_[k].front(), borders_[k].back());
      return static_cast<std::size_t>(std::lower_bound(borders_[k].begin(), borders_[k].end(), within) -
                                      borders_[k].begin());
    };
    low[k] = number_of(rectangle.sides[k].low);
    end[k] = number_of(rectangle.sides[k].high);
  }
  for (std::size_t row = low[1]; row < end[1]; ++row) {
    const auto begin = covered_.begin() + static_cast<std::ptrdiff_t>(row * (borders_[0].size() - 1));
    std::fill(begin + static_cast<std::ptrdiff_t>(low[0]), begin + static_cast<std::ptrdiff_t>(end[0]),
              char{1});
  }
}

// From the first free part on, as wide as it goes, then as high.
void FreeRectangles::take_rectangles(const Rectangle& whole) {
  const std::size_t columns = borders_[0].size() - 1;
  const std::size_t rows = borders_[1].size() - 1;
  const auto covered = [&](std::size_t column, std::size_t row) -> char& {
    return covered_[row * columns + column];
  };
  const auto row_is_free = [&](std::size_t row, std::size_t from, std::size_t end) {
    for (std::size_t column = from; column < end; ++column)
      if (covered(column, row) != 0) return false;
    return true;
  };
  Rectangle opening = whole;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      if (covered(column, row) != 0) continue;
      std::size_t right = column + 1;
      while (right < columns && covered(right, row) == 0) ++right;
      std::size_t top = row + 1;
      while (top < rows && row_is_free(top, column, right)) ++top;
      opening.sides = {Span{borders_[0][column], borders_[0][right]},
                       Span{borders_[1][row], borders_[1][top]}};
      cover(opening);
      free_.push_back(opening);
    }
  }
}

}  // namespace sightline::scene
