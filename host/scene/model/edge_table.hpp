// Numbers the edges of a scene and lists the faces at each.
//
// An edge is a pair of consecutive vertices of an outline or a hole, or a wire. Edges ascend by their lower
// and then by their higher vertex, as in a LinePicture, so that both number them alike.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

class EdgeTable {
 public:
  // One side of a face.
  struct Use {
    std::uint32_t face : 31;    // counted over all bodies from 0
    std::uint32_t upwards : 1;  // traversed from the lower to the higher vertex
  };
  struct Edge {
    VertexIndex low = 0;
    VertexIndex high = 0;
    std::uint32_t first = 0;  // of its uses
  };

  // Every index of a face or wire is below the number of vertices (precondition). Sides from a vertex to
  // itself are left out. Linear time, except for sorting the sides at a vertex. `jobs` threads; the table is the same for any number.
  explicit EdgeTable(const PolyScene& scene, unsigned jobs = 1);
  // Of faces without holes.
  EdgeTable(std::size_t vertices, std::span<const Ring* const> outlines, unsigned jobs = 1);

  [[nodiscard]] std::size_t size() const { return edges_.size() - 1; }
  [[nodiscard]] const Edge& operator[](std::size_t edge) const { return edges_[edge]; }
  // The number of the edge between two vertices; size() if there is none. Logarithmic time.
  [[nodiscard]] std::size_t find(VertexIndex a, VertexIndex b) const;
  // Ascending by face; empty for a wire that is not a side of a face.
  [[nodiscard]] std::span<const Use> uses(std::size_t edge) const {
    return std::span(uses_).subspan(edges_[edge].first, edges_[edge + 1].first - edges_[edge].first);
  }

 private:
  template <class ForSides>
  void build(std::size_t vertices, unsigned jobs, ForSides for_sides);

  std::vector<Edge> edges_;  // with one more entry, where the uses end
  std::vector<Use> uses_;
};

}  // namespace sightline::scene
