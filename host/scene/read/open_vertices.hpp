// The ends of the open edges of a mesh, those that only one face of a body has: where each is in the file, and which lie
// near each other or on an edge.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "host/geometry/box_tree.hpp"
#include "host/scene/model/edge_table.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

// From one corner of its face to the next one.
struct OpenEdge {
  VertexIndex from = 0;
  VertexIndex to = 0;
  std::uint32_t face = 0;  // counted over all bodies from 0
  std::uint32_t body = 0;
};

// body_of_face(face) is the body of a face, counted over all bodies. Linear.
template <class BodyOfFace>
[[nodiscard]] std::vector<OpenEdge> open_edges_of(const EdgeTable& edges, BodyOfFace body_of_face) {
  std::vector<OpenEdge> open;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto uses = edges.uses(e);
    const auto same_body = [&](std::size_t i, std::size_t j) {
      return j < uses.size() && body_of_face(uses[i].face) == body_of_face(uses[j].face);
    };
    if (uses.size() == 2 && same_body(0, 1)) continue;
    for (std::size_t i = 0; i < uses.size(); ++i) {
      if (same_body(i, i + 1) || (i > 0 && same_body(i, i - 1))) continue;
      const auto& edge = edges[e];
      open.push_back({uses[i].upwards ? edge.low : edge.high, uses[i].upwards ? edge.high : edge.low, uses[i].face,
                      body_of_face(uses[i].face)});
    }
  }
  return open;
}

class OpenVertices {
 public:
  using FilePoint = std::array<double, 3>;

  // `target`: for each vertex of the file the one of `points` that it became.
  OpenVertices(const std::vector<PolyPoint>& points, std::span<const OpenEdge> edges, std::span<const FilePoint> file,
               std::span<const VertexIndex> target);

  [[nodiscard]] std::span<const VertexIndex> vertices() const { return vertices_; }
  // Where a vertex is in the file: ascending, each point once.
  [[nodiscard]] std::span<const FilePoint> in_file(VertexIndex vertex) const;

  // Pairs of them on neighbouring points that are nearer to each other in the file than `distance`; the nearest first, and
  // of equally near ones those with the lower coordinates.
  [[nodiscard]] std::vector<std::pair<VertexIndex, VertexIndex>> near_pairs(double distance) const;

  // Those of the edge's body, but its own ends, that are between `from` and `to`, its ends in the file, and at most
  // `tolerance` from the line. In the order in which the edge passes them. `step` is that of the grid; `work` goes up by the
  // number of boxes and points that are tried.
  [[nodiscard]] std::vector<VertexIndex> on_edge(const OpenEdge& edge, const FilePoint& from, const FilePoint& to,
                                                 double tolerance, double step, std::size_t& work) const;

 private:
  [[nodiscard]] std::size_t number_of(VertexIndex vertex) const;

  const std::vector<PolyPoint>& points_;
  std::vector<VertexIndex> vertices_;                                // ascending
  std::vector<std::pair<VertexIndex, std::uint32_t>> with_bodies_;  // each with each body whose open edges end there
  std::vector<FilePoint> file_points_;
  std::vector<std::size_t> first_;  // of each of vertices_ in file_points_, and where they end
  geometry::BoxTree tree_;
};

// Distances for --weld, in grid steps and ascending, with which open edges of a scene may meet: from the end of an open edge to the
// nearest other one. At most a hundredth of the size of each body, and less than half of the open edges at each end, so that
// no detail is lost. None if fewer than `least_joints` pairs of open edges become one with all of them.
[[nodiscard]] std::vector<double> weld_distances(const PolyScene& scene, std::size_t least_joints);

}  // namespace sightline::scene
