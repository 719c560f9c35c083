// Joins the pieces of a boundary to loops: Montani and Re's way from stripes back to outlines and
// holes.
//
// Every piece is directed so that the inside is to its left. At a point where several pieces go on, the
// sharpest turn to the left is taken, so that loops that only touch stay apart. Nothing is said here of
// where points lie: a heading is any number that grows counterclockwise about its point. So lattice stripes
// and trapezoids between exact lines are traced by the same code. Source: Montani and Re (1985), section 4.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace sightline::algorithms::montani_re {

struct BoundaryPiece {
  std::uint32_t from = 0;  // points, as the caller numbers them
  std::uint32_t to = 0;
  std::int64_t leaving = 0;  // heading at `from`, towards `to`
  std::int64_t back = 0;     // heading at `to`, towards `from`
};

// Loops as indices of pieces in the order walked, every piece in exactly one loop. At every point as many
// pieces arrive as leave (precondition). Loops begin at their piece of the lowest index and ascend by it.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> trace_boundary(std::span<const BoundaryPiece> pieces);

}  // namespace sightline::algorithms::montani_re
