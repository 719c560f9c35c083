#include "host/algorithms/exact/edge_mesh.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace sightline::algorithms::exact {
namespace {

using scene::VertexIndex;

// Appends the corners of one ring.
void append_ring(std::span<const VertexIndex> ring, EdgeMesh& mesh) {
  const std::size_t first = mesh.corners.size();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (ring[i] != ring[i + 1 == ring.size() ? 0 : i + 1]) mesh.corners.push_back({ring[i] & 0x7fffffffU, 0});
  }
  if (mesh.corners.size() > first) mesh.corners.back().last_of_ring = 1;
}

// Twice the area, as a vector: the sum of cross products about the first corner. Partial sums may wrap; the result is
// exact.
Vector area_of(const EdgeMesh& mesh, const Corner* corners, std::uint32_t count) {
  std::array<std::uint64_t, 3> sum{};
  const geometry::Point3& about = mesh.vertices[corners->vertex];
  for_sides(corners, count, [&](std::uint32_t i, std::uint32_t next) {
    const Vector part = geometry::cross(geometry::difference(mesh.vertices[corners[i].vertex], about),
                                        geometry::difference(mesh.vertices[corners[next].vertex], about));
    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += static_cast<std::uint64_t>(part[axis]);
  });
  return {static_cast<std::int64_t>(sum[0]), static_cast<std::int64_t>(sum[1]),
          static_cast<std::int64_t>(sum[2])};
}

// Leaves out a face without corners, which no checked scene has.
void append_face(const scene::PolyFace& given, bool sheet, EdgeMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.corners.size());
  append_ring(given.outline, mesh);
  for (const auto& hole : given.holes) append_ring(hole, mesh);
  const auto count = static_cast<std::uint32_t>(mesh.corners.size() - first);
  if (count == 0) return;
  MeshFace& face = mesh.faces.emplace_back();
  face.normal = PackedNormal(area_of(mesh, mesh.corners.data() + first, count));
  face.first_corner = first;
  face.corner_count = count & 0x7fffffffU;
  face.sheet = sheet ? 1 : 0;
}

// Calls visit(corner, edge) for every side of every face.
template <class Visit>
void for_all_sides(const EdgeMesh& mesh, Visit visit) {
  for (const MeshFace& face : mesh.faces) {
    const Corner* const corners = mesh.corners_of(face);
    for_sides(corners, face.corner_count, [&](std::uint32_t i, std::uint32_t next) {
      const VertexIndex a = corners[i].vertex;
      const VertexIndex b = corners[next].vertex;
      visit(face.first_corner + i, picture::LineEdge{std::min(a, b), std::max(a, b)});
    });
  }
}

// A side of a face, from the vertex by which the sides are grouped.
struct Side {
  VertexIndex to = 0;
  std::uint32_t corner = 0;
};

void sort_by_end(Side* begin, Side* end) {
  constexpr std::ptrdiff_t few = 24;
  if (end - begin > few) {
    std::sort(begin, end, [](const Side& a, const Side& b) { return a.to < b.to; });
    return;
  }
  for (Side* i = begin; i < end; ++i) {
    const Side side = *i;
    Side* to = i;
    for (; to != begin && to[-1].to > side.to; --to) *to = to[-1];
    *to = side;
  }
}

// Collects sides and wires, sorted by the lower vertex (counting sort), then by the higher; then crossings.
void number_edges(EdgeMesh& mesh, const scene::PolyScene& scene) {
  constexpr std::uint32_t no_corner = ~0U;
  const auto for_wires = [&scene](auto visit) {
    for (const auto& [a, b] : scene.wires)
      if (a != b) visit(no_corner, picture::LineEdge{std::min(a, b), std::max(a, b)});
  };
  std::vector<std::uint32_t> start(mesh.vertices.size() + 1);
  const auto count = [&](std::uint32_t, const picture::LineEdge& edge) { ++start[edge.from + 1]; };
  for_all_sides(mesh, count);
  for_wires(count);
  for (std::size_t v = 1; v < start.size(); ++v) start[v] += start[v - 1];
  std::vector<Side> sides(start.back());
  std::vector<std::uint32_t> fill(start.begin(), start.end() - 1);
  const auto add = [&](std::uint32_t corner, const picture::LineEdge& edge) { sides[fill[edge.from]++] = {edge.to, corner}; };
  for_all_sides(mesh, add);
  for_wires(add);
  mesh.edges.reserve(sides.size() / 2 + scene.wires.size() + scene.crossings.size());
  mesh.sides.resize(mesh.corners.size());
  for (VertexIndex v = 0; v + 1 < start.size(); ++v) {
    sort_by_end(sides.data() + start[v], sides.data() + start[v + 1]);
    for (std::uint32_t i = start[v]; i < start[v + 1]; ++i) {
      if (i == start[v] || sides[i].to != sides[i - 1].to) mesh.edges.push_back({v, sides[i].to});
      const auto edge = static_cast<std::uint32_t>(mesh.edges.size() - 1);
      if (sides[i].corner != no_corner) mesh.sides[sides[i].corner] = edge;
      else mesh.wires.push_back(edge);
    }
  }
  for (const scene::PolyCrossing& crossing : scene.crossings) mesh.edges.push_back({crossing.from, crossing.to});
}

LineEnd end_of(const scene::PolyScene& scene, const scene::CutPoint& cut) {
  const geometry::Point3& p = scene.vertices[cut.p];
  const geometry::Point3& q = scene.vertices[cut.q];
  return cut.a > cut.b ? LineEnd{p, q, cut.a, cut.b} : LineEnd{p, q, -cut.a, -cut.b};
}

void append_lines(const scene::PolyScene& scene, EdgeMesh& mesh) {
  const auto plane_of = [&](std::uint32_t face) {
    const MeshFace& of = mesh.faces[face];
    const geometry::Point3& on = mesh.vertices[mesh.corners[of.first_corner].vertex];
    const Vector normal = of.normal.unpacked();
    return geometry::Plane{normal, geometry::dot(normal, geometry::vector_of(on))};
  };
  mesh.lines.reserve(scene.crossings.size());
  for (const scene::PolyCrossing& crossing : scene.crossings) {
    const bool on_one = crossing.face_a == crossing.face_b;
    mesh.lines.push_back({{plane_of(crossing.face_a), on_one ? scene.cut_planes[crossing.plane] : plane_of(crossing.face_b)},
                          {end_of(scene, crossing.ends[0]), end_of(scene, crossing.ends[1])}});
  }
}

}  // namespace

EdgeMesh make_edge_mesh(const scene::PolyScene& scene, bool of_all_edges) {
  EdgeMesh mesh;
  mesh.vertices = scene.vertices;
  mesh.surfaces = scene.surface_of;
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
  for (const scene::PolyBody& body : scene.bodies)
    for (const scene::PolyFace& face : body.faces) append_face(face, body.sheet, mesh);
  if (of_all_edges) number_edges(mesh, scene);
  append_lines(scene, mesh);
  return mesh;
}

}  // namespace sightline::algorithms::exact
