// Joins the pieces of a boundary to loops: Montani and Re's step from stripes back to outlines and holes.
//
// Every piece is directed with the inside to its left. At a point where several pieces leave, the sharpest left turn is
// taken, so that loops that only touch stay separate. The code does not use positions of points: a heading is any number
// that grows counterclockwise about its point. Source: Montani and Re (1985), section 4.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace sightline::algorithms::montani_re {

struct BoundaryPiece {
  std::uint32_t from = 0;  // point numbers of the caller
  std::uint32_t to = 0;
  std::int64_t leaving = 0;  // heading at `from`, towards `to`
  std::int64_t back = 0;     // heading at `to`, towards `from`
};

// Returns loops as indices of pieces in walking order; every piece is in exactly one loop. Precondition: at every point
// as many pieces arrive as leave. Each loop starts at its piece of the lowest index; the loops ascend by it.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> trace_boundary(std::span<const BoundaryPiece> pieces);

}  // namespace sightline::algorithms::montani_re
