// See polygon.hpp.
#include "host/scene/cells/bsp/polygon.hpp"

#include <cassert>
#include <utility>

#include "host/scene/cells/bsp/predicates.hpp"

namespace sightline::scene {
namespace {

void find_corner(const Planes& planes, PlanePolygon& polygon, std::size_t i) {
  polygon.sides[i].from =
      integer_meeting(planes[polygon.plane], planes[polygon.sides[polygon.previous(i)].half.plane],
                      planes[polygon.sides[i].half.plane]);
}

// The part of a polygon with corners on both sides of `plane` that is in front of it (sign 1) or behind it
// (-1).
PlanePolygon part_of(const Planes& planes, const PlanePolygon& polygon, const std::vector<int>& corners,
                     std::uint32_t plane, int sign) {
  std::size_t i = 0;
  while (corners[i] == sign || corners[polygon.next(i)] != sign) i = polygon.next(i);
  const bool begins_at_corner = corners[i] == 0;
  PlanePolygon part;
  part.plane = polygon.plane;
  part.sides.reserve(polygon.sides.size() + 1);
  do {
    part.sides.push_back(polygon.sides[i]);
    i = polygon.next(i);
  } while (corners[i] == sign);
  part.sides.push_back({{plane, sign > 0}, polygon.sides[i].from});
  if (corners[i] != 0) find_corner(planes, part, part.sides.size() - 1);
  if (!begins_at_corner) find_corner(planes, part, 0);
  return part;
}

}  // namespace

int corner_side(const Planes& planes, const PlanePolygon& polygon, std::size_t i, std::uint32_t plane) {
  const PlanePolygon::Side& side = polygon.sides[i];
  if (side.from) return planes[plane].side(*side.from);
  const std::uint32_t before = polygon.sides[polygon.previous(i)].half.plane;
  if (plane == polygon.plane || plane == side.half.plane || plane == before) return 0;
  return side_of_meeting(planes[plane], planes[polygon.plane], planes[before], planes[side.half.plane]);
}

PolygonSides sides_of(const Planes& planes, const PlanePolygon& polygon, std::uint32_t plane) {
  PolygonSides sides;
  for (std::size_t i = 0; i < polygon.sides.size() && !sides.both(); ++i) {
    const int side = corner_side(planes, polygon, i, plane);
    sides.behind = sides.behind || side < 0;
    sides.in_front = sides.in_front || side > 0;
  }
  return sides;
}

SplitPolygon split(const Planes& planes, PlanePolygon polygon, std::uint32_t plane) {
  std::vector<int> corners(polygon.sides.size());
  PolygonSides sides;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    corners[i] = corner_side(planes, polygon, i, plane);
    sides.behind = sides.behind || corners[i] < 0;
    sides.in_front = sides.in_front || corners[i] > 0;
  }
  SplitPolygon parts;
  if (sides.both()) {
    parts.behind = part_of(planes, polygon, corners, plane, -1);
    parts.in_front = part_of(planes, polygon, corners, plane, 1);
  } else if (sides.behind) {
    parts.behind = std::move(polygon);
  } else if (sides.in_front) {
    parts.in_front = std::move(polygon);
  }
  return parts;
}

PlanePolygon clip_to(const Planes& planes, PlanePolygon polygon, HalfSpace half) {
  const PolygonSides sides = sides_of(planes, polygon, half.plane);
  if (!(half.turned ? sides.in_front : sides.behind)) return {};
  if (!sides.both()) return polygon;
  SplitPolygon parts = split(planes, std::move(polygon), half.plane);
  return half.turned ? std::move(parts.in_front) : std::move(parts.behind);
}

PlanePolygon intersection(const Planes& planes, PlanePolygon a, const PlanePolygon& b) {
  assert(a.plane == b.plane);
  for (std::size_t i = 0; i < b.sides.size() && !a.empty(); ++i) {
    a = clip_to(planes, std::move(a), b.sides[i].half);
  }
  return a;
}

// The axis along which the plane's normal is longest is left out. The plane crosses the prism between the
// four box planes of the other two axes in a parallelogram.
PlanePolygon widest_polygon(CellComplexBuilder& builder, std::uint32_t plane) {
  const geometry::Box outer = builder.complex().outer;
  const geometry::Vector3 normal = builder.complex().planes[plane].normal;
  const std::size_t axis = geometry::dominant_axis(normal);
  const std::size_t u = (axis + 1) % 3;
  const std::size_t v = (axis + 2) % 3;
  PlanePolygon polygon;
  polygon.plane = plane;
  // From the positive end of the axis, u to v is counterclockwise; from the other end, clockwise.
  const HalfSpace low_v = builder.at_least(v, outer.low[v]);
  const HalfSpace high_v = builder.at_most(v, outer.high[v]);
  const bool same_end = normal[axis] > 0;
  polygon.sides.push_back({same_end ? low_v : high_v, std::nullopt});
  polygon.sides.push_back({builder.at_most(u, outer.high[u]), std::nullopt});
  polygon.sides.push_back({same_end ? high_v : low_v, std::nullopt});
  polygon.sides.push_back({builder.at_least(u, outer.low[u]), std::nullopt});
  for (std::size_t i = 0; i < polygon.sides.size(); ++i) find_corner(builder.complex().planes, polygon, i);
  return polygon;
}

}  // namespace sightline::scene
