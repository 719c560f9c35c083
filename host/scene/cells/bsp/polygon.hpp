// A convex polygon in a plane, given by planes only, and how a plane splits it.
//
// Its sides are the lines where other planes cross its own; a corner is where two neighbouring sides meet. A
// corner that is an integer point is remembered as such, because most are and a plane's side of it is then
// one scalar product; of the others only the three planes are known. Every side has a length, every
// polygon an area, except the empty polygon, which has no sides.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "host/geometry/box.hpp"
#include "host/geometry/predicates.hpp"
#include "host/scene/model/cell_complex.hpp"
#include "host/scene/cells/builder.hpp"

namespace sightline::scene {

using Planes = std::vector<geometry::Plane>;  // all of them, by number

// Side i goes from corner i to corner i + 1, counterclockwise as seen from where the plane's normal points
// to.
struct PlanePolygon {
  struct Side {
    HalfSpace half;
    std::optional<geometry::Point3> from;  // the corner it starts at, if that is known to be integer
  };

  std::uint32_t plane = 0;
  std::vector<Side> sides;

  [[nodiscard]] bool empty() const { return sides.empty(); }
  [[nodiscard]] std::size_t next(std::size_t i) const { return i + 1 == sides.size() ? 0 : i + 1; }
  [[nodiscard]] std::size_t previous(std::size_t i) const { return (i == 0 ? sides.size() : i) - 1; }
};

// On which sides of a plane a polygon has corners.
struct PolygonSides {
  bool behind = false;  // where the plane is negative
  bool in_front = false;

  [[nodiscard]] bool both() const { return behind && in_front; }
};

// On which side of plane number `plane` corner i is.
[[nodiscard]] int corner_side(const Planes& planes, const PlanePolygon& polygon, std::size_t i,
                              std::uint32_t plane);
[[nodiscard]] PolygonSides sides_of(const Planes& planes, const PlanePolygon& polygon, std::uint32_t plane);

struct SplitPolygon {
  PlanePolygon behind;
  PlanePolygon in_front;
};

// What is of the polygon on either side; of a polygon in the plane itself, nothing.
[[nodiscard]] SplitPolygon split(const Planes& planes, PlanePolygon polygon, std::uint32_t plane);

// What is in the half-space.
[[nodiscard]] PlanePolygon clipped(const Planes& planes, PlanePolygon polygon, HalfSpace half);

// What a and b, in the same plane, have in common.
[[nodiscard]] PlanePolygon intersection(const Planes& planes, PlanePolygon a, const PlanePolygon& b);

// A parallelogram in `plane` that contains all of the plane that is in the box.
[[nodiscard]] PlanePolygon widest_polygon(CellComplexBuilder& builder, std::uint32_t plane);

}  // namespace sightline::scene
