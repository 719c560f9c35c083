// Decides exactly whether convex polygons are within a given distance of each other.
//
// Distances are first computed in double, with a bound of the rounding error. If the result is closer to the limit than
// that, it is recomputed in integers of sufficient width.
// A polygon of two points is a segment.
#pragma once

#include <cstdint>
#include <vector>

#include "host/algorithms/willis/surface.hpp"

namespace sightline::algorithms::willis {

// Whether the squared distance of p from the polygon is at most `limit`. `normal` is the normal of the polygon's plane;
// it is ignored for a segment.
[[nodiscard]] bool within(const Point& p, const std::vector<Point>& polygon, const Vector3& normal,
                          std::uint64_t limit);

// Whether the squared distance between edges of the two polygons, or between a corner of one and the other, is at most
// `limit`. This is the distance of the polygons if the limit is at least the square of either's diameter.
[[nodiscard]] bool within(const Surface& s, const Surface& t, std::uint64_t limit);

// Whether the two have a point in common. Exact in 128 bits.
[[nodiscard]] bool meet(const Surface& s, const Surface& t);

// The same questions, answered without the floating-point filter.
[[nodiscard]] bool within_exactly(const Point& p, const std::vector<Point>& polygon, const Vector3& normal,
                                  std::uint64_t limit);
[[nodiscard]] bool within_exactly(const Surface& s, const Surface& t, std::uint64_t limit);

}  // namespace sightline::algorithms::willis
