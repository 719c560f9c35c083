// A convex polygon in a plane, given by planes only; splitting and clipping it by other planes.
//
// A side is the line where another plane crosses the polygon's own; a corner is where two consecutive sides
// meet. A corner that is an integer point is stored as one: most are, and the side of a plane that it is on
// is then one scalar product. Other corners are known by their three planes only. Every side has a length and
// every polygon an area, except the empty polygon, which has no sides.
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

using Planes = std::vector<geometry::Plane>;  // by number

// Side i goes from corner i to corner i + 1, counterclockwise as seen from the side that the plane's normal
// points to.
struct PlanePolygon {
  struct Side {
    HalfSpace half;
    std::optional<geometry::Point3> from;  // the corner it starts at, if known to be an integer point
  };

  std::uint32_t plane = 0;
  std::vector<Side> sides;

  [[nodiscard]] bool empty() const { return sides.empty(); }
  [[nodiscard]] std::size_t next(std::size_t i) const { return i + 1 == sides.size() ? 0 : i + 1; }
  [[nodiscard]] std::size_t previous(std::size_t i) const { return (i == 0 ? sides.size() : i) - 1; }
};

// The sides of a plane on which a polygon has corners.
struct PolygonSides {
  bool behind = false;  // the plane's negative side
  bool in_front = false;

  [[nodiscard]] bool both() const { return behind && in_front; }
};

// The side of plane number `plane` on which corner i is: -1, 0 or 1.
[[nodiscard]] int corner_side(const Planes& planes, const PlanePolygon& polygon, std::size_t i,
                              std::uint32_t plane);
[[nodiscard]] PolygonSides sides_of(const Planes& planes, const PlanePolygon& polygon, std::uint32_t plane);

struct SplitPolygon {
  PlanePolygon behind;
  PlanePolygon in_front;
};

// The parts of the polygon on either side of the plane. Of a polygon in the plane, both are empty.
[[nodiscard]] SplitPolygon split(const Planes& planes, PlanePolygon polygon, std::uint32_t plane);

// The part of the polygon in the half-space.
[[nodiscard]] PlanePolygon clip_to(const Planes& planes, PlanePolygon polygon, HalfSpace half);

// The intersection of a and b, which are in the same plane.
[[nodiscard]] PlanePolygon intersection(const Planes& planes, PlanePolygon a, const PlanePolygon& b);

// A parallelogram in `plane` that contains the plane's intersection with the outer box.
[[nodiscard]] PlanePolygon widest_polygon(CellComplexBuilder& builder, std::uint32_t plane);

}  // namespace sightline::scene
