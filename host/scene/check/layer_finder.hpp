// Whether triangles form a layer: someone who looks along an axis of the scene sees the front of each, and no two overlap. Then no two
// of them cross. Nearly all parts of a smooth surface are layers, and to find this out takes less time than to try each pair.
//
// How many of the triangles cover a point is how many times their outline goes around it (its winding number). The outline is all edges
// that are not between two of the triangles. If none of its sides cross, it is enough to count beside each side.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

using Triangle = std::array<VertexIndex, 3>;

class LayerFinder {
 public:
  explicit LayerFinder(std::span<const PolyPoint> vertices) : vertices_(vertices) {}

  // False also for layers whose outline has more than two sides more than there are triangles, so that they are not connected, or has sides
  // that meet other than in a corner of both.
  [[nodiscard]] bool is_layer(std::span<const Triangle> triangles);

 private:
  struct Edge {
    std::uint64_t ends = 0;   // the lesser vertex above the greater one; 0 in a free place of the table
    std::int32_t surplus = 0;  // how many more triangles go from the lesser to the greater vertex than back
  };
  // In the picture of a viewer: to the right and upwards.
  struct Point {
    std::int64_t right = 0;
    std::int64_t up = 0;
  };
  // The triangles are to the left of it.
  struct Side {
    std::array<VertexIndex, 2> vertices{};
    std::array<Point, 2> ends;
    Point low;
    Point high;
  };

  void count_edge(VertexIndex from, VertexIndex to);
  // Those who see the front of all triangles. Bit 0 is the viewer at +x, 1 at -x, 2 at +y, ...
  [[nodiscard]] unsigned viewers_of(std::span<const Triangle> triangles) const;
  // In the picture of this viewer. False if an edge or the number of sides does not fit a layer.
  [[nodiscard]] bool find_outline(std::span<const Triangle> triangles, unsigned viewer);
  // Whether two sides have a point in common that is not a corner of both.
  [[nodiscard]] static bool meet(const Side& a, const Side& b);
  // How many triangles cover the points at the left of the middle of a side.
  [[nodiscard]] int covering(const Side& side) const;
  // Twice the area of a triangle, positive if it is turned to the left.
  [[nodiscard]] static std::int64_t turn(const Point& a, const Point& b, const Point& c) {
    return (b.right - a.right) * (c.up - a.up) - (b.up - a.up) * (c.right - a.right);
  }

  std::span<const PolyPoint> vertices_;
  std::vector<Edge> table_;          // by a hash of the ends; its size is a power of two
  std::vector<std::uint32_t> used_;  // its places
  std::vector<Side> outline_;
};

}  // namespace sightline::scene
