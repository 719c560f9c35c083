// The data of a polyhedral scene that exact drawing needs, for any eye: numbered edges, faces as runs of
// corners, precomputed planes.
//
// Sizes, coordinates below 2^18: a face normal (twice the area, as a vector) 39 bits, a point against its
// plane 60 bits. An end of a crossing, relative to an eye, has 80 over 61 bits; a plane of sight there 121, and so has a
// corner against the plane of sight through the crossing.
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

// A corner of a face and the side that leaves it: to the next corner, or to the first one of its ring.
struct Corner {
  std::uint32_t vertex : 31;
  std::uint32_t last_of_ring : 1;
  std::uint32_t side;  // index of an edge
};

// Three numbers of 40 bits.
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

// Where a plane cuts the line from p to q: a and b are values of the plane there, one of which is not 0.
struct LineEnd {
  geometry::Point3 p{};
  geometry::Point3 q{};
  std::int64_t a = 0;  // above b
  std::int64_t b = 0;
};

// A crossing of the scene: where two planes meet, in the direction of the cross product of their normals.
struct MeshLine {
  std::array<geometry::Plane, 2> planes{};
  std::array<LineEnd, 2> ends{};
};

// Corners and faces are most of the memory of a large scene: 8 and 24 bytes each.
struct EdgeMesh {
  std::span<const geometry::Point3> vertices;  // of the scene
  std::vector<picture::LineEdge> edges;  // ascending, as edges_of has them, and then the scene's crossings
  std::vector<MeshLine> lines;           // the crossings
  std::vector<std::uint32_t> wires;      // among the edges
  std::vector<Corner> corners;
  std::vector<MeshFace> faces;
  std::vector<std::uint32_t> surfaces;  // of each face, as PolyScene::surface_of has it; empty: 0 for all

  [[nodiscard]] std::size_t first_line() const { return edges.size() - lines.size(); }  // among the edges
  [[nodiscard]] const Corner* corners_of(const MeshFace& face) const { return corners.data() + face.first_corner; }
  [[nodiscard]] std::uint32_t surface_of(std::uint32_t face) const { return surfaces.empty() ? 0 : surfaces[face]; }
};

// Calls visit(i, next) for each side of a face: the numbers, from 0, of the corners that it leaves and reaches.
template <class Visit>
void for_sides(const Corner* corners, std::uint32_t count, Visit visit) {
  std::uint32_t first = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    visit(i, corners[i].last_of_ring != 0 ? first : i + 1);
    if (corners[i].last_of_ring != 0) first = i + 1;
  }
}

// The scene is a checked one (precondition) and outlives the mesh. Linear in its size, but for sorting the edges at a vertex.
[[nodiscard]] EdgeMesh make_edge_mesh(const scene::PolyScene& scene);

}  // namespace sightline::algorithms::exact
