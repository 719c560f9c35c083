// What a plane cuts out of a face: pieces of the line that their planes have in common. The ends are points in which a side
// of the face meets the plane (CutPoint); they are compared exactly, by one coordinate along the line, which is a fraction of
// 80 over 61 bits.
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

// The axis along which the line of two planes with these normals is longest, and the sign along it of their cross product:
// 0 if they are parallel.
struct CutAxis {
  std::size_t axis = 0;
  int sign = 0;
};
[[nodiscard]] CutAxis cut_axis(const geometry::Vector3& m, const geometry::Vector3& n);

// A point of the line, with its coordinate along the axis.
struct CutPlace {
  CutPoint point;
  geometry::Int128 numerator = 0;
  std::int64_t denominator = 1;  // positive
  double value = 0;
};

[[nodiscard]] int compare(const CutPlace& x, const CutPlace& y);

// Pieces of the line from a lower to a higher place, which ascend and do not overlap.
using FaceCuts = std::vector<std::pair<CutPlace, CutPlace>>;

// What of the line is in the face if corners in the plane count as beyond it, or as before it. `zero` becomes true if there
// are such corners.
[[nodiscard]] FaceCuts cuts_of(std::span<const PolyPoint> vertices, const PolyFace& face, const geometry::Plane& plane,
                               std::size_t axis, bool zero_is_beyond, bool& zero);
// What two lists of pieces of one line have in common.
[[nodiscard]] FaceCuts common(const FaceCuts& a, const FaceCuts& b);

// The point rounded once to the nearest of the grid, halves upwards; and in floating point.
[[nodiscard]] PolyPoint rounded(std::span<const PolyPoint> vertices, const CutPoint& point);
[[nodiscard]] std::array<double, 3> real(std::span<const PolyPoint> vertices, const CutPoint& point);

// Adds a line to the crossings of a scene, with vertices of its own for its ends.
void add_crossing(PolyScene& scene, std::uint32_t face_a, std::uint32_t face_b, std::uint32_t plane,
                  const std::array<CutPoint, 2>& ends);

// Where a vertex is, be it one of faces or the end of a crossing, which is then not rounded.
[[nodiscard]] std::array<double, 3> place_of(const PolyScene& scene, VertexIndex vertex);

// The plane of a face; its normal is twice the area of the outline, as a vector.
[[nodiscard]] geometry::Plane plane_of(std::span<const PolyPoint> vertices, const PolyFace& face);

}  // namespace sightline::scene
