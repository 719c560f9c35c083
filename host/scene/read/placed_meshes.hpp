// Meshes that a file defines once and places by transforms, made one PolyMesh: the common part of the readers of glTF and
// 3MF.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/model/vertex_pool.hpp"
#include "host/scene/read/poly_import.hpp"

namespace sightline::scene {

// The first three rows of a matrix whose fourth is 0 0 0 1: x' = m[0][0] x + m[0][1] y + m[0][2] z + m[0][3].
using Transform = std::array<std::array<double, 4>, 3>;
constexpr Transform no_transform{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
// `a` after `b`.
[[nodiscard]] Transform product(const Transform& a, const Transform& b);

// Triangles in coordinates of their own.
struct LocalMesh {
  std::string place;  // named in errors: "3D/3dmodel.model, object 2"
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::uint32_t> corners;  // three per triangle; every index is below vertices.size()
  double precision = 0;                // as PolyMesh::precision, in these coordinates
  std::uint32_t material = 0;
};

// The most corners of triangles that a file may have, copies counted, and the most copies of meshes.
constexpr std::size_t most_placed_corners = 100'000'000;
constexpr std::size_t most_placed_copies = 1'000'000;

// Renumbers the vertices that corners name from 0 upwards, in their order, and returns the numbers they had: for a mesh that has
// more vertices than corners.
[[nodiscard]] std::vector<std::uint32_t> number_used_vertices(std::vector<std::uint32_t>& corners);

class PlacedMeshes {
 public:
  PlacedMeshes() : pool_(mesh_.vertices) {}
  PlacedMeshes(const PlacedMeshes&) = delete;
  PlacedMeshes& operator=(const PlacedMeshes&) = delete;

  void begin_body(std::string name);
  // A copy of the mesh, in the body begun last; a mirror image is turned right side out. Errors: a coordinate that is no finite
  // number, more copies or corners than the limits allow.
  [[nodiscard]] base::Result<base::Done> add(const LocalMesh& mesh, const Transform& transform);
  // All meshes, once; an error if there are no faces.
  [[nodiscard]] base::Result<PolyMesh> take();

 private:
  PolyMesh mesh_;
  VertexPool<double> pool_;
  double local_precision_ = 0;
  std::size_t corners_ = 0;
  std::size_t copies_ = 0;
};

}  // namespace sightline::scene
