#include "host/algorithms/exact/edge_mesh.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace sightline::algorithms::exact {
namespace {

using scene::VertexIndex;

// Corners of one ring; sides are filled in when all edges are known.
void append_ring(const std::vector<VertexIndex>& ring, std::uint32_t first_corner, EdgeMesh& mesh) {
  const std::size_t first = mesh.corners.size();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (ring[i] != ring[i + 1 == ring.size() ? 0 : i + 1]) mesh.corners.push_back({ring[i], 0, 0});
  }
  const std::size_t count = mesh.corners.size() - first;
  for (std::size_t i = 0; i < count; ++i) {
    mesh.corners[first + i].next =
        static_cast<std::uint32_t>(first + (i + 1 == count ? 0 : i + 1) - first_corner);
  }
}

// Twice the area, as a vector: cross products about the first corner, whose partial sums wrap without harm.
Vector area_of(const EdgeMesh& mesh, std::uint32_t first_corner) {
  std::array<std::uint64_t, 3> sum{};
  const geometry::Point3& about = mesh.vertices[mesh.corners[first_corner].vertex];
  for (std::size_t i = first_corner; i < mesh.corners.size(); ++i) {
    const Corner& corner = mesh.corners[i];
    const Vector part =
        geometry::cross(geometry::difference(mesh.vertices[corner.vertex], about),
                        geometry::difference(mesh.vertices[mesh.corners[first_corner + corner.next].vertex], about));
    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += static_cast<std::uint64_t>(part[axis]);
  }
  return {static_cast<std::int64_t>(sum[0]), static_cast<std::int64_t>(sum[1]),
          static_cast<std::int64_t>(sum[2])};
}

void append_face(const scene::PolyFace& given, bool sheet, std::uint32_t surface, EdgeMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.corners.size());
  append_ring(given.outline, first, mesh);
  for (const auto& hole : given.holes) append_ring(hole, first, mesh);
  const auto count = static_cast<std::uint32_t>(mesh.corners.size() - first);
  if (count == 0) return;
  mesh.faces.push_back({area_of(mesh, first), first, count, surface, sheet});
}

picture::LineEdge side_of(const EdgeMesh& mesh, const MeshFace& face, const Corner& corner) {
  const VertexIndex a = corner.vertex;
  const VertexIndex b = mesh.corners[face.first_corner + corner.next].vertex;
  return {std::min(a, b), std::max(a, b)};
}

// Sides sorted by their lower vertex by counting, then by the higher within the few of one vertex. Leaves room for
// the edges of crossings.
void number_edges(EdgeMesh& mesh, std::size_t crossings) {
  std::vector<std::uint32_t> start(mesh.vertices.size() + 1);
  for (const MeshFace& face : mesh.faces) {
    for (std::uint32_t i = 0; i < face.corner_count; ++i) {
      ++start[side_of(mesh, face, mesh.corners[face.first_corner + i]).from + 1];
    }
  }
  for (std::size_t v = 1; v < start.size(); ++v) start[v] += start[v - 1];
  struct Side {
    VertexIndex to = 0;
    std::uint32_t corner = 0;
  };
  std::vector<Side> sides(start.back());
  std::vector<std::uint32_t> fill(start.begin(), start.end() - 1);
  for (const MeshFace& face : mesh.faces) {
    for (std::uint32_t i = face.first_corner; i < face.first_corner + face.corner_count; ++i) {
      const picture::LineEdge edge = side_of(mesh, face, mesh.corners[i]);
      sides[fill[edge.from]++] = {edge.to, i};
    }
  }
  mesh.edges.reserve(sides.size() / 2 + crossings);
  for (VertexIndex v = 0; v + 1 < start.size(); ++v) {
    std::sort(sides.data() + start[v], sides.data() + start[v + 1],
              [](const Side& a, const Side& b) { return a.to < b.to; });
    for (std::uint32_t i = start[v]; i < start[v + 1]; ++i) {
      if (i == start[v] || sides[i].to != sides[i - 1].to) mesh.edges.push_back({v, sides[i].to});
      mesh.corners[sides[i].corner].side = static_cast<std::uint32_t>(mesh.edges.size() - 1);
    }
  }
}

}  // namespace

EdgeMesh make_edge_mesh(const scene::PolyScene& scene) {
  EdgeMesh mesh;
  mesh.vertices = scene.vertices;
  std::size_t faces = 0;
  std::size_t corners = 0;
  for (const scene::PolyBody& body : scene.bodies) {
    faces += body.faces.size();
    for (const scene::PolyFace& face : body.faces) {
      corners += face.outline.size();
      for (const auto& hole : face.holes) corners += hole.size();
    }
  }
  mesh.faces.reserve(faces);
  mesh.corners.reserve(corners);
  std::size_t number = 0;
  for (const scene::PolyBody& body : scene.bodies) {
    for (const scene::PolyFace& face : body.faces) {
      append_face(face, body.sheet, scene.surface_of.empty() ? 0 : scene.surface_of[number], mesh);
      ++number;
    }
  }
  number_edges(mesh, scene.crossings.size());
  for (const scene::PolyCrossing& crossing : scene.crossings) mesh.edges.push_back({crossing.from, crossing.to});
  return mesh;
}

}  // namespace sightline::algorithms::exact
