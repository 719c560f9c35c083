// The boundary around a surface within which ordering by distance may be wrong, and the pair test based on it.
//
// oval: all points nearer to the surface than its length L (in three dimensions its diameter), the solid line of
//   Fig. 6. ball: the smallest such boundary, the union of the balls about the vertices v with radius rho(v), the
//   distance of v from the farthest vertex; in plan the two circles of Fig. 6's broken line.
// A pair is a cluster iff either surface has a point inside or on the boundary of the other (the test is made both
// ways, because it is not symmetric), and one can obscure the other at all.
#pragma once

#include <cstdint>

#include "host/algorithms/willis/surface.hpp"

namespace sightline::algorithms::willis {

enum class BoundaryShape { oval, ball };

struct PairRules {
  BoundaryShape shape = BoundaryShape::ball;
  // The paper's third condition of property 6: normals must be within 90 degrees (inclusive). It is wrong: real
  // occlusions violate it, and then pixels are wrong.
  bool rule90 = false;
};

// Property 6: whether s can hide any part of t from some eye to which both are turned: t has a point behind the plane of
// s, and s has one in front of the plane of t. False for two faces of one convex solid and for two faces in one plane.
[[nodiscard]] bool can_obscure(const Surface& s, const Surface& t, bool rule90 = false);

// Whether p is inside or on the boundary of s.
[[nodiscard]] bool in_boundary(const Surface& s, const Point& p, BoundaryShape shape);

// Whether t has a point inside or on the boundary of s; the two do not cross. Not symmetric.
[[nodiscard]] bool reaches(const Surface& t, const Surface& s, BoundaryShape shape);
// Whether either reaches the other.
[[nodiscard]] bool reach_each_other(const Surface& s, const Surface& t, BoundaryShape shape);

[[nodiscard]] bool form_cluster(const Surface& s, const Surface& t, const PairRules& rules);

// Areas of the boundaries of a wall of length 1 in plan.
[[nodiscard]] double oval_area();           // pi + 2
[[nodiscard]] double two_circles_area();    // 4 pi / 3 + sqrt(3) / 2
[[nodiscard]] double halves_ovals_area();   // of the union of the ovals of its two halves: 1 + pi / 4

}  // namespace sightline::algorithms::willis
