// See faces.hpp. A BSP in two dimensions (Thibault and Naylor 1987): a part through which no edge passes is
// inside or outside, as the last edge that it was cut along says, because that edge bounds it.
#include "host/scene/cells/bsp/faces.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "host/geometry/predicates.hpp"
#include "host/geometry/rational.hpp"

namespace sightline::scene {
namespace {

// A part of an edge of a face; the face lies to its left.
struct FaceSide {
  PolyPoint from;
  PolyPoint to;
  HalfSpace inner;         // of the plane through the edge: contains the face near it
  geometry::Rational low;  // from + s (to - from), low < s < high
  geometry::Rational high;
};

struct FacePart {
  PlanePolygon polygon;
  std::vector<FaceSide> sides;  // those that pass through the inside of the part
};

struct SplitSides {
  std::vector<FaceSide> behind;
  std::vector<FaceSide> in_front;
};

// Appends the parts of a side on both sides of a plane. A side in the plane has none.
void split_side(const geometry::Plane& plane, const FaceSide& side, SplitSides& parts) {
  const std::int64_t from = plane.at(side.from);
  const std::int64_t to = plane.at(side.to);
  if (from == to) {
    if (from != 0) (from < 0 ? parts.behind : parts.in_front).push_back(side);
    return;
  }
  const geometry::Rational cut(from, from - to);
  FaceSide before = side;
  before.high = std::min(side.high, cut);
  if (before.low < before.high) (from < to ? parts.behind : parts.in_front).push_back(before);
  FaceSide after = side;
  after.low = std::max(side.low, cut);
  if (after.low < after.high) (from < to ? parts.in_front : parts.behind).push_back(after);
}

SplitSides split_sides(const geometry::Plane& plane, const std::vector<FaceSide>& sides) {
  SplitSides parts;
  for (const FaceSide& side : sides) split_side(plane, side, parts);
  return parts;
}

// The line of the side that cuts the fewest others, of up to 16 evenly spaced sides.
HalfSpace best_cut(const Planes& planes, const std::vector<FaceSide>& sides) {
  constexpr std::size_t most_sides_tried = 16;
  const std::size_t step = (sides.size() + most_sides_tried - 1) / most_sides_tried;
  std::size_t best = 0;
  std::size_t fewest = sides.size() * 2 + 1;
  for (std::size_t i = 0; i < sides.size() && fewest >= sides.size(); i += step) {
    const SplitSides parts = split_sides(planes[sides[i].inner.plane], sides);
    const std::size_t count = parts.behind.size() + parts.in_front.size();
    if (count < fewest) {
      fewest = count;
      best = i;
    }
  }
  return sides[best].inner;
}

class FaceCutter {
 public:
  FaceCutter(const PolyScene& scene, CellComplexBuilder& builder) : scene_(scene), builder_(builder) {}

  // Appends the pieces of a face.
  void cut(const PolyFace& face, bool sheet, std::vector<FacePiece>& pieces) {
    const HalfSpace behind = builder_.behind(plane_of(face));
    FacePart whole{widest_polygon(builder_, behind.plane), {}};
    add_ring(face.outline, behind, whole.sides);
    for (const auto& hole : face.holes) add_ring(hole, behind, whole.sides);
    std::vector<FacePart> parts{std::move(whole)};
    while (!parts.empty()) {
      FacePart part = std::move(parts.back());
      parts.pop_back();
      const HalfSpace inner = best_cut(planes(), part.sides);
      SplitPolygon polygons = split(planes(), std::move(part.polygon), inner.plane);
      SplitSides sides = split_sides(planes()[inner.plane], part.sides);
      const auto keep = [&](PlanePolygon& polygon, std::vector<FaceSide>& rest, bool is_inner) {
        if (!rest.empty()) {
          parts.push_back({std::move(polygon), std::move(rest)});
        } else if (is_inner) {
          pieces.push_back({std::move(polygon), sheet, behind.turned});
        }
      };
      keep(polygons.behind, sides.behind, !inner.turned);
      keep(polygons.in_front, sides.in_front, inner.turned);
    }
  }

 private:
  [[nodiscard]] const Planes& planes() const { return builder_.complex().planes; }

  // Through three vertices of the outline that are not collinear. The normal points to the side from which
  // the outline is counterclockwise.
  [[nodiscard]] geometry::Plane plane_of(const PolyFace& face) const {
    const auto point = [&](std::size_t i) { return scene_.vertices[face.outline[i % face.outline.size()]]; };
    // The vertex farthest along an axis, ties broken by the next axes, is a corner of the convex hull.
    std::size_t corner = 0;
    for (std::size_t i = 1; i < face.outline.size(); ++i) {
      if (point(i) > point(corner)) corner = i;
    }
    const std::size_t count = face.outline.size();
    return geometry::plane_through(point(corner + count - 1), point(corner), point(corner + 1));
  }

  void add_ring(std::span<const VertexIndex> ring, HalfSpace behind, std::vector<FaceSide>& sides) {
    geometry::Vector3 normal = planes()[behind.plane].normal;
    if (behind.turned) normal = geometry::negated(normal);
    const std::size_t axis = geometry::dominant_axis(normal);
    geometry::Vector3 along{};
    along[axis] = normal[axis] > 0 ? 1 : -1;  // the direction the face looks in
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const PolyPoint& from = scene_.vertices[ring[i]];
      const PolyPoint& to = scene_.vertices[ring[i + 1 == ring.size() ? 0 : i + 1]];
      const geometry::Vector3 outwards = geometry::cross(geometry::difference(to, from), along);
      const geometry::Plane plane{outwards, geometry::dot(outwards, geometry::vector_of(from))};
      sides.push_back({from, to, builder_.behind(plane), geometry::Rational(0), geometry::Rational(1)});
    }
  }

  const PolyScene& scene_;
  CellComplexBuilder& builder_;
};

}  // namespace

std::vector<FacePiece> face_pieces(const PolyScene& scene, CellComplexBuilder& builder) {
  std::vector<FacePiece> pieces;
  FaceCutter cutter(scene, builder);
  for (const PolyBody& body : scene.bodies) {
    for (const PolyFace& face : body.faces) cutter.cut(face, body.sheet, pieces);
  }
  return pieces;
}

}  // namespace sightline::scene
