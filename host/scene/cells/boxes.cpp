// See boxes.hpp.
#include "host/scene/cells/boxes.hpp"

#include <algorithm>
#include <array>

namespace sightline::scene {

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
  // Seen from above, x turns to z clockwise.
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
