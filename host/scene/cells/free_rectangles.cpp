// See free_rectangles.hpp.
#include "host/scene/cells/free_rectangles.hpp"

#include <algorithm>
#include <array>

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

// Marks the parts that the rectangle covers, clipped to the whole. Its sides are borders of parts if they lie
// within.
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

// From the first free part, as wide as possible, then as high.
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

CellNumber add_box_cell(CellComplexBuilder& builder, const geometry::Box& box) {
  std::array<HalfSpace, 6> bounds{};
  for (std::size_t a = 0; a < 3; ++a) {
    bounds[2 * a] = builder.at_least(a, box.low[a]);
    bounds[2 * a + 1] = builder.at_most(a, box.high[a]);
  }
  return builder.add_cell(bounds);
}

void add_rectangle_opening(CellComplexBuilder& builder, const geometry::Rectangle& opening, CellNumber below,
                           CellNumber above) {
  const auto [u, v] = geometry::other_axes(opening.axis);
  const auto& [along_u, along_v] = opening.sides;
  std::array<HalfSpace, 4> sides{builder.at_least(v, along_v.low), builder.at_most(u, along_u.high),
                                 builder.at_most(v, along_v.high), builder.at_least(u, along_u.low)};
  // Seen from above, x to z is clockwise.
  if (opening.axis == 1) std::reverse(sides.begin(), sides.end());
  builder.add_opening(builder.at_most(opening.axis, opening.at), below, above, sides);
}

void add_openings_outside(CellComplexBuilder& builder, CellNumber cell, const geometry::Box& box) {
  const geometry::Box& outer = builder.complex().outer;
  for (std::size_t a = 0; a < 3; ++a) {
    if (box.low[a] == outer.low[a])
      add_rectangle_opening(builder, geometry::face_of(box, a, false), outside, cell);
    if (box.high[a] == outer.high[a])
      add_rectangle_opening(builder, geometry::face_of(box, a, true), cell, outside);
  }
}

void add_axis_line(CellComplexBuilder& builder, std::uint32_t edge, std::size_t axis, CellNumber cell,
                   std::int32_t low, std::int32_t high) {
  const CellComplex& complex = builder.complex();
  const std::int64_t from = complex.vertices[complex.edges[edge].from][axis];
  const std::int64_t to = complex.vertices[complex.edges[edge].to][axis];
  if (std::min(from, to) == low && std::max(from, to) == high) return builder.add_line(cell, edge, 0, 1);
  const std::int64_t length = to - from;
  const geometry::Rational a{low - from, length};
  const geometry::Rational b{high - from, length};
  builder.add_line(cell, edge, std::min(a, b), std::max(a, b));
}

}  // namespace sightline::scene
