// See poly_shells.hpp.
#include "host/scene/check/poly_shells.hpp"

#include <algorithm>
#include <numeric>
#include <span>
#include <tuple>

#include "host/geometry/predicates.hpp"

namespace sightline::scene {
namespace {

// Calls visit(edge) for each side of the faces.
template <class Visit>
void for_face_edges(const PolyBody& body, Visit visit) {
  for (std::size_t f = 0; f < body.faces.size(); ++f) {
    const auto add_ring = [&](const Ring& ring) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const VertexIndex from = ring[i];
        const VertexIndex to = ring[i + 1 == ring.size() ? 0 : i + 1];
        visit(FaceEdge{std::min(from, to), std::max(from, to), f, from < to});
      }
    };
    add_ring(body.faces[f].outline);
    for (const Ring& hole : body.faces[f].holes) add_ring(hole);
  }
}

std::size_t first_connected(std::vector<std::size_t>& parents, std::size_t face) {
  while (parents[face] != face) {
    parents[face] = parents[parents[face]];
    face = parents[face];
  }
  return face;
}

}  // namespace

std::vector<FaceEdge> face_edges(const PolyBody& body) {
  VertexIndex least = ~VertexIndex{0};
  VertexIndex most = 0;
  std::size_t count = 0;
  for_face_edges(body, [&](const FaceEdge& edge) {
    least = std::min(least, edge.low);
    most = std::max(most, edge.low);
    ++count;
  });
  const auto before = [](const FaceEdge& a, const FaceEdge& b) {
    return std::tie(a.low, a.high, a.face, a.upwards) < std::tie(b.low, b.high, b.face, b.upwards);
  };
  std::vector<FaceEdge> edges;
  edges.reserve(count);
  // The vertices of a body mostly follow each other: then its edges are sorted by their lower vertex by counting.
  if (count == 0 || most - least > 4 * count) {
    for_face_edges(body, [&](const FaceEdge& edge) { edges.push_back(edge); });
    std::sort(edges.begin(), edges.end(), before);
    return edges;
  }
  std::vector<std::size_t> ends(most - least + 1);
  for_face_edges(body, [&](const FaceEdge& edge) { ++ends[edge.low - least]; });
  std::size_t sum = 0;
  for (std::size_t& end : ends) sum = std::exchange(end, sum) + sum;
  edges.resize(count);
  for_face_edges(body, [&](const FaceEdge& edge) { edges[ends[edge.low - least]++] = edge; });
  std::size_t begin = 0;
  for (const std::size_t end : ends) {
    std::sort(edges.begin() + static_cast<std::ptrdiff_t>(begin), edges.begin() + static_cast<std::ptrdiff_t>(end), before);
    begin = end;
  }
  return edges;
}

bool is_closed(const std::vector<FaceEdge>& edges) {
  if (edges.size() % 2 != 0) return false;
  for (std::size_t i = 0; i < edges.size(); i += 2) {
    if (!edges[i].same_edge(edges[i + 1]) || edges[i].upwards == edges[i + 1].upwards) return false;
    if (i + 2 < edges.size() && edges[i].same_edge(edges[i + 2])) return false;
  }
  return true;
}

std::vector<std::size_t> connected_faces(const PolyBody& body, const std::vector<FaceEdge>& edges) {
  std::vector<std::size_t> parents(body.faces.size());
  std::iota(parents.begin(), parents.end(), std::size_t{0});
  for (std::size_t i = 1; i < edges.size(); ++i) {
    if (!edges[i].same_edge(edges[i - 1])) continue;
    const std::size_t a = first_connected(parents, edges[i].face);
    const std::size_t b = first_connected(parents, edges[i - 1].face);
    parents[std::max(a, b)] = std::min(a, b);
  }
  // A root is the smallest face of its part, so that it is met before the others.
  std::vector<std::size_t> parts(body.faces.size());
  std::size_t count = 0;
  for (std::size_t f = 0; f < parts.size(); ++f) {
    const std::size_t root = first_connected(parents, f);
    parts[f] = root == f ? count++ : parts[root];
  }
  return parts;
}

geometry::Int128 enclosed_volume(const std::vector<PolyPoint>& vertices, std::span<const VertexIndex> outline) {
  geometry::Int128 volume = 0;
  const auto origin = geometry::vector_of(vertices[outline[0]]);
  for (std::size_t i = 2; i < outline.size(); ++i)
    volume += geometry::dot(origin, geometry::cross(geometry::vector_of(vertices[outline[i - 1]]), geometry::vector_of(vertices[outline[i]])));
  return volume;
}

geometry::Int128 enclosed_volume(const std::vector<PolyPoint>& vertices, const PolyFace& face) {
  geometry::Int128 volume = enclosed_volume(vertices, std::span<const VertexIndex>(face.outline));
  for (const auto& hole : face.holes) volume += enclosed_volume(vertices, std::span<const VertexIndex>(hole));
  return volume;
}

geometry::Int128 enclosed_volume(const std::vector<PolyPoint>& vertices, const PolyBody& body) {
  geometry::Int128 volume = 0;
  for (const PolyFace& face : body.faces) volume += enclosed_volume(vertices, face);
  return volume;
}

}  // namespace sightline::scene
