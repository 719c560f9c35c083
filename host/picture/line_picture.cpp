#include "host/picture/line_picture.hpp"

#include <algorithm>
#include <cstddef>

namespace sightline::picture {
namespace {

void append_ring(const std::vector<scene::VertexIndex>& ring, std::vector<LineEdge>& edges) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const scene::VertexIndex a = ring[i];
    const scene::VertexIndex b = ring[i + 1 == ring.size() ? 0 : i + 1];
    if (a != b) edges.push_back({std::min(a, b), std::max(a, b)});
  }
}

}  // namespace

std::vector<LineEdge> edges_of(const scene::PolyScene& scene) {
  std::vector<LineEdge> edges;
  for (const scene::PolyBody& body : scene.bodies) {
    for (const scene::PolyFace& face : body.faces) {
      append_ring(face.outline, edges);
      for (const auto& hole : face.holes) append_ring(hole, edges);
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

}  // namespace sightline::picture
