// The data of a polyhedral scene that exact drawing needs, for any eye: numbered edges, faces as runs of
// corners, precomputed planes.
//
// Sizes, coordinates below 2^18: a face normal (twice the area, as a vector) 39 bits, a point against its
// plane 60 bits.
#pragma once

#include <cstdint>
#include <vector>

#include "host/geometry/predicates.hpp"
#include "host/picture/line_picture.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::exact {

using Vector = geometry::Vector3;

// A corner of a face and the side that leaves it.
struct Corner {
  std::uint32_t vertex = 0;
  std::uint32_t side = 0;  // index of an edge
  std::uint32_t next = 0;  // the other end of the side, counted from the first corner of the face
};

struct MeshFace {
  Vector normal{};  // outwards
  std::uint32_t first_corner = 0;
  std::uint32_t corner_count = 0;
  std::uint32_t surface = 0;  // as PolyScene::surface_of has it
  bool sheet = false;
};

struct EdgeMesh {
  std::vector<geometry::Point3> vertices;
  std::vector<picture::LineEdge> edges;  // ascending, as edges_of has them, and then the scene's crossings
  std::vector<Corner> corners;
  std::vector<MeshFace> faces;
};

// The scene is a checked one (precondition). Linear in its size, but for sorting the edges at a vertex.
[[nodiscard]] EdgeMesh make_edge_mesh(const scene::PolyScene& scene);

}  // namespace sightline::algorithms::exact
