// Where surfaces over the same places pass through each other: what of a line lies on the eye's side of all others, and the line
// in which two of them meet within half a cell.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "host/algorithms/skala/coverage.hpp"
#include "host/algorithms/skala/horizon.hpp"

namespace sightline::algorithms::skala {

// How far a place of a surface is on the eye's side of each other surface, in heights.
using Leads = std::vector<double>;

// Of a line between two places: where it leads all others. Empty: first > last.
[[nodiscard]] LinePart leading_part(std::span<const double> from, std::span<const double> to);

// Of a line of which `before` is seen as long as nothing of its cell is there, and `after` with the other surfaces there: the former where
// it leads, the latter elsewhere.
[[nodiscard]] std::vector<Piece> seen_where(Vertex from, Vertex to, const LinePart& leads, const std::vector<Piece>& before,
                                            const std::vector<Piece>& after);

// A side of a triangle, by the numbers of its ends, and where on it from the first: the same seen from both sides.
struct Meeting {
  std::size_t a = 0;
  std::size_t b = 0;
  double at = 0;
};

// Where the difference of two surfaces is zero on a triangle, given at its corners; of a side whose ends differ in whether they are above 0.
[[nodiscard]] std::optional<std::array<Meeting, 2>> meeting_line(const std::array<double, 3>& differences);

}  // namespace sightline::algorithms::skala
