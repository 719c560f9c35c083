// The camera-independent data that exact drawing needs of a polyhedral scene: faces as runs of corners with precomputed
// planes, and numbered edges.
//
// Sizes, with coordinates below 2^18: a face normal (twice the area, as a vector) has 39 bits, the value of a plane at a
// point 60. Relative to an eye, an end of a crossing is a fraction of 80 over 61 bits; the value of a plane of sight at
// such an end has 121 bits, and so has the value at a corner of the plane of sight through the crossing.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/geometry/predicates.hpp"
#include "host/picture/line_picture.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::exact {

using Vector = geometry::Vector3;

// A corner of a face. Its side leads to the next corner of its ring (from the last to the first).
struct Corner {
  std::uint32_t vertex : 31;
  std::uint32_t last_of_ring : 1;
};

// Three integers of 40 bits each.
class PackedNormal {
 public:
  PackedNormal() = default;
  explicit PackedNormal(const Vector& normal) {
    const auto bits = [&normal](std::size_t axis) { return static_cast<std::uint64_t>(normal[axis]) & ((std::uint64_t{1} << 40) - 1); };
    low_ = bits(0) | bits(1) << 40;
    high_ = bits(1) >> 24 | bits(2) << 16;
  }
  [[nodiscard]] Vector unpacked() const {
    return {static_cast<std::int64_t>(low_ << 24) >> 24,
            static_cast<std::int64_t>(high_ << 48 | (low_ >> 40) << 24) >> 24,
            static_cast<std::int64_t>(high_ << 8) >> 24};
  }

 private:
  std::uint64_t low_ = 0;   // the first, and 24 bits of the second
  std::uint64_t high_ = 0;  // 16 bits of the second, and the third
};

struct MeshFace {
  PackedNormal normal;  // outwards
  std::uint32_t first_corner = 0;
  std::uint32_t corner_count : 31 = 0;
  std::uint32_t sheet : 1 = 0;
};

// The point where a plane cuts the line from p to q: a and b are the plane's values at p and q, not both 0.
struct LineEnd {
  geometry::Point3 p{};
  geometry::Point3 q{};
  std::int64_t a = 0;  // greater than b
  std::int64_t b = 0;
};

// A crossing of the scene: the line in which two planes meet, directed like the cross product of their normals.
struct MeshLine {
  std::array<geometry::Plane, 2> planes{};
  std::array<LineEnd, 2> ends{};
};

// Corners and faces take most of the memory of a large scene: 4 and 24 bytes each. All edges take 8 bytes each, and 4 each side.
struct EdgeMesh {
  std::span<const geometry::Point3> vertices;  // of the scene; those of crossings are the last
  std::vector<MeshLine> lines;                 // one for each crossing
  std::vector<Corner> corners;
  std::vector<MeshFace> faces;
  std::span<const std::uint32_t> surfaces;  // of each face: PolyScene::surface_of; empty: 0 for all
  // For views of all edges; empty for views of chosen ones.
  std::vector<picture::LineEdge> edges;  // ascending, in the order of edges_of; then the scene's crossings
  std::vector<std::uint32_t> sides;      // by corner: number of the edge of its side
  std::vector<std::uint32_t> wires;      // numbers of edges

  // From this vertex on, each two are the ends of a crossing.
  [[nodiscard]] std::size_t first_line_vertex() const { return vertices.size() - 2 * lines.size(); }
  [[nodiscard]] const Corner* corners_of(const MeshFace& face) const { return corners.data() + face.first_corner; }
  [[nodiscard]] std::uint32_t surface_of(std::uint32_t face) const { return surfaces.empty() ? 0 : surfaces[face]; }
};

// Calls visit(i, next) for each side of a face, with the numbers, from 0, of its first and second corner.
template <class Visit>
void for_sides(const Corner* corners, std::uint32_t count, Visit visit) {
  std::uint32_t first = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    visit(i, corners[i].last_of_ring != 0 ? first : i + 1);
    if (corners[i].last_of_ring != 0) first = i + 1;
  }
}

// Precondition: the scene is checked and outlives the mesh. Linear time, except for sorting the edges at each vertex, which is left out
// if all views will be of chosen edges.
[[nodiscard]] EdgeMesh make_edge_mesh(const scene::PolyScene& scene, bool of_all_edges = true);

}  // namespace sightline::algorithms::exact
