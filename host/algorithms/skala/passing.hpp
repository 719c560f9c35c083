// Surfaces that pass through each other: the part of a line that is on the eye's side of all other surfaces, and the line
// in which two surfaces meet within half a cell.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "host/algorithms/skala/coverage.hpp"
#include "host/algorithms/skala/horizon.hpp"

namespace sightline::algorithms::skala {

// How far a point of a surface is on the eye's side of each other surface, in units of height.
using Leads = std::vector<double>;

// The part of a line between two points where it leads all other surfaces; empty if first > last.
[[nodiscard]] LinePart leading_part(std::span<const double> from, std::span<const double> to);

// The visible pieces of a line. `before` is visible as long as nothing else of its cell is drawn, `after` once the other
// surfaces of the cell are drawn. The result is `before` where the line leads and `after` elsewhere.
[[nodiscard]] std::vector<Piece> visible_pieces(Vertex from, Vertex to, const LinePart& leads, const std::vector<Piece>& before,
                                            const std::vector<Piece>& after);

// A point on a side of a triangle: the numbers of the side's ends and the parameter from the first. It does not depend on
// which of the side's two triangles is given.
struct Meeting {
  std::size_t a = 0;
  std::size_t b = 0;
  double at = 0;
};

// The line on a triangle where the difference of two surfaces, given at the corners, is zero. It ends on the sides of
// which only one end is above 0.
[[nodiscard]] std::optional<std::array<Meeting, 2>> meeting_line(const std::array<double, 3>& differences);

}  // namespace sightline::algorithms::skala
