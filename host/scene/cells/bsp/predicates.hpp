// The side of a plane on which three others meet: the predicate for cutting space by planes.
//
// Limits: components of normals below 2^40, so that determinants of normals, sums of six products of three,
// stay below 2^123; offsets below 2^61. Nothing rounds: 0 means exactly on the plane.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "host/geometry/integer.hpp"
#include "host/geometry/predicates.hpp"
#include "host/geometry/wide_integer.hpp"

namespace sightline::scene {

// The side of `plane` on which a, b and c meet. Their normals are independent.
[[nodiscard]] constexpr int side_of_meeting(const geometry::Plane& plane, const geometry::Plane& a,
                                            const geometry::Plane& b, const geometry::Plane& c) {
  const geometry::Int128 all = geometry::determinant(a.normal, b.normal, c.normal);
  using Determinant = geometry::WideInteger<123>;
  using Offset = geometry::WideInteger<61>;
  const auto sum = Determinant(geometry::determinant(plane.normal, b.normal, c.normal)) * Offset(a.offset) +
                   Determinant(geometry::determinant(plane.normal, c.normal, a.normal)) * Offset(b.offset) +
                   Determinant(geometry::determinant(plane.normal, a.normal, b.normal)) * Offset(c.offset) -
                   Determinant(all) * Offset(plane.offset);
  return sum.sign() * geometry::sign(all);
}

// The point where a, b and c meet, if its coordinates are integers of magnitude at most 2^18. Their normals
// are independent. If floating point cannot decide, the result is empty; a point that is returned is right.
[[nodiscard]] std::optional<geometry::Point3> integer_meeting(const geometry::Plane& a,
                                                              const geometry::Plane& b,
                                                              const geometry::Plane& c);

}  // namespace sightline::scene
