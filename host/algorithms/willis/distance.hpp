// Whether convex polygons come as near as a given distance, exactly.
//
// Distances are first computed in double, with a bound on what rounding can have done; only if the question
// is closer than that is it decided again in integers as wide as their sizes need.
// A polygon of two points is a segment.
#pragma once

#include <cstdint>
#include <vector>

#include "host/algorithms/willis/surface.hpp"

namespace sightline::algorithms::willis {

// The distance of p from the polygon, squared, is at most `limit`. The normal is that of the polygon's plane,
// and is not looked at for a segment.
[[nodiscard]] bool within(const Point& p, const std::vector<Point>& polygon, const Vector3& normal,
                          std::uint64_t limit);

// The distance between the edges of the two polygons, and of their corners from the other one, squared, is at
// most `limit`: the distance of the polygons, if the limit is not below the square of either's diameter.
[[nodiscard]] bool within(const Surface& s, const Surface& t, std::uint64_t limit);

// The two have a point in common. Exact in 128 bits.
[[nodiscard]] bool meet(const Surface& s, const Surface& t);

// The same questions, answered without the filter.
[[nodiscard]] bool within_exactly(const Point& p, const std::vector<Point>& polygon, const Vector3& normal,
                                  std::uint64_t limit);
[[nodiscard]] bool within_exactly(const Surface& s, const Surface& t, std::uint64_t limit);

}  // namespace sightline::algorithms::willis
