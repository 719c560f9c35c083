// The Delaunay triangulation of points in the plane, exact: no circle through the corners of a triangle has a point inside.
//
// Divide and conquer on quad-edges: Guibas, Stolfi, "Primitives for the manipulation of general subdivisions and the computation
// of Voronoi diagrams", ACM Transactions on Graphics 4 (1985), section 9. O(n log n). Of points on one circle any diagonal is taken.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "host/geometry/predicates.hpp"

namespace sightline::scene {

// Positive if d is inside of the circle through a, b, c, which turn counterclockwise; 0 on it.
[[nodiscard]] int in_circle(const geometry::Point2& a, const geometry::Point2& b, const geometry::Point2& c,
                            const geometry::Point2& d);

// Counterclockwise triangles of the points' numbers, which cover their convex hull. Coordinates below
// geometry::predicate_coordinate_limit. Of equal points one takes part. None if all points are on a line.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> delaunay(std::span<const geometry::Point2> points);

}  // namespace sightline::scene
