// Intersects faces with planes: the parts of a face on the line where a plane crosses the face's plane. Their
// ends are points where a side of the face meets the plane (CutPoint). The points are compared exactly, by
// one coordinate along the line, a fraction of 80 over 61 bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "host/geometry/predicates.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

// The axis along which the intersection line of two planes with these normals is longest, and the sign of
// their cross product along it: 0 if they are parallel.
struct CutAxis {
  std::size_t axis = 0;
  int sign = 0;
};
[[nodiscard]] CutAxis cut_axis(const geometry::Vector3& m, const geometry::Vector3& n);

// A point of the line and its coordinate along the axis.
struct CutPlace {
  CutPoint point;
  geometry::Int128 numerator = 0;
  std::int64_t denominator = 1;  // positive
  double value = 0;
};

[[nodiscard]] int compare(const CutPlace& x, const CutPlace& y);

// Pieces of the line from a lower to a higher place, ascending and disjoint.
using FaceCuts = std::vector<std::pair<CutPlace, CutPlace>>;

// The parts of the line in the face. Corners in the plane count as beyond it if zero_is_beyond, otherwise as
// before it. Sets `zero` if there are such corners.
[[nodiscard]] FaceCuts cuts_of(std::span<const PolyPoint> vertices, const PolyFace& face, const geometry::Plane& plane,
                               std::size_t axis, bool zero_is_beyond, bool& zero);
// The intersection of two lists of pieces of one line.
[[nodiscard]] FaceCuts common(const FaceCuts& a, const FaceCuts& b);

// The point rounded once to the nearest grid point, halves upwards; and in floating point.
[[nodiscard]] PolyPoint rounded(std::span<const PolyPoint> vertices, const CutPoint& point);
[[nodiscard]] std::array<double, 3> real(std::span<const PolyPoint> vertices, const CutPoint& point);

// Adds a line to the crossings of a scene, with new vertices for its ends.
void add_crossing(PolyScene& scene, std::uint32_t face_a, std::uint32_t face_b, std::uint32_t plane,
                  const std::array<CutPoint, 2>& ends);

// The position of a vertex. An end of a crossing is not rounded.
[[nodiscard]] std::array<double, 3> place_of(const PolyScene& scene, VertexIndex vertex);

// The plane of a face. Its normal is twice the area of the outline, as a vector.
[[nodiscard]] geometry::Plane plane_of(std::span<const PolyPoint> vertices, const PolyFace& face);

}  // namespace sightline::scene
