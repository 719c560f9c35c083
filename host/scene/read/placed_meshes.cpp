// See placed_meshes.hpp.
#include "host/scene/read/placed_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "host/scene/read/poly_text.hpp"
#include "host/scene/read/precision.hpp"

namespace sightline::scene {
namespace {

std::array<double, 3> transformed(const Transform& m, const std::array<double, 3>& p) {
  std::array<double, 3> result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = m[i][0] * p[0] + m[i][1] * p[1] + m[i][2] * p[2] + m[i][3];
  return result;
}

bool mirrors(const Transform& m) {
  const double determinant = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                             m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                             m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  return determinant < 0;
}

}  // namespace

Transform product(const Transform& a, const Transform& b) {
  Transform result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      result[i][j] = j == 3 ? a[i][3] : 0;
      for (std::size_t k = 0; k < 3; ++k) result[i][j] += a[i][k] * b[k][j];
    }
  }
  return result;
}

std::vector<std::uint32_t> number_used_vertices(std::vector<std::uint32_t>& corners) {
  std::vector<std::uint32_t> used = corners;
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (std::uint32_t& v : corners) v = static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), v) - used.begin());
  return used;
}

void PlacedMeshes::begin_body(std::string name) {
  if (!mesh_.bodies.empty() && mesh_.bodies.back().faces.empty()) mesh_.bodies.pop_back();
  mesh_.bodies.emplace_back().name = printable_name(std::move(name));
}

base::Result<base::Done> PlacedMeshes::add(const LocalMesh& mesh, const Transform& transform) {
  corners_ += mesh.corners.size();
  if (corners_ > most_placed_corners || ++copies_ > most_placed_copies) {
    const bool corners = corners_ > most_placed_corners;
    return base::Error{"", mesh.place,
                       "found more than " + std::to_string(corners ? most_placed_corners : most_placed_copies) +
                           (corners ? " corners of faces, copies counted" : " copies of meshes"),
                       "", "export fewer copies, or fewer faces"};
  }
  constexpr VertexIndex unknown = std::numeric_limits<VertexIndex>::max();
  std::vector<VertexIndex> number(mesh.vertices.size(), unknown);
  const bool mirror = mirrors(transform);
  PolyBody& body = mesh_.bodies.back();
  for (std::size_t t = 0; t < mesh.corners.size(); t += 3) {
    PolyFace face;
    face.outline.resize(3);
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t v = mesh.corners[t + (mirror ? 2 - c : c)];
      if (number[v] == unknown) {
        const std::array<double, 3> point = transformed(transform, mesh.vertices[v]);
        if (!std::isfinite(point[0]) || !std::isfinite(point[1]) || !std::isfinite(point[2]))
          return base::Error{"", mesh.place + ", vertex " + std::to_string(v), "found a coordinate that is no finite number",
                             "a number"};
        number[v] = pool_.add(point);
      }
      face.outline[c] = number[v];
    }
    body.faces.push_back(std::move(face));
    mesh_.materials.push_back(mesh.material);
  }
  double scale = 0;
  for (const auto& row : transform) scale = std::max(scale, std::abs(row[0]) + std::abs(row[1]) + std::abs(row[2]));
  local_precision_ = std::max(local_precision_, scale * mesh.precision);
  return base::Done{};
}

base::Result<PolyMesh> PlacedMeshes::take() {
  if (!mesh_.bodies.empty() && mesh_.bodies.back().faces.empty()) mesh_.bodies.pop_back();
  if (mesh_.bodies.empty()) return base::Error{"", "", "found no faces", "a mesh", "points and lines hide nothing"};
  mesh_.grouped = mesh_.bodies.size() > 1;
  if (std::all_of(mesh_.materials.begin(), mesh_.materials.end(), [&](std::uint32_t m) { return m == mesh_.materials[0]; }))
    mesh_.materials.clear();
  mesh_.precision = std::max(local_precision_, float32_precision(mesh_.vertices));
  return std::move(mesh_);
}

}  // namespace sightline::scene
