// Scenes with cells and openings for hard cases that need more than a picture and counts. The inputs of J1 to J17 are data of the
// report (host/compare/hard_cases/data) and are tested there.
//
// The eye is at the origin and looks along z. Corridor: cell 0 is z -100..100, cell i is z 100i..100(i+1), x and y at most 50;
// between cells i-1 and i is a wall with a portal at z = 100i. Walls are sheets; the outer box is the corridor.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "host/scene/model/poly_scene.hpp"
#include "tests/host/algorithms/jones/box_complex.hpp"

namespace sightline::algorithms {

struct HardCase {
  scene::PolyScene scene;
  geometry::Box outer;
  std::vector<geometry::Box> cells;
  std::vector<BoxOpening> openings;
  scene::PolyCamera camera;

  [[nodiscard]] scene::CellComplex complex() const { return complex_of_boxes(scene, outer, cells, openings); }
};

// A wall without thickness, optionally with a hole strictly inside it.
inline void add_wall(scene::PolyScene& scene, const geometry::Rectangle& wall,
                     const geometry::Rectangle* hole = nullptr) {
  const auto ring = [&scene](const geometry::Rectangle& r, bool forwards) {
    const geometry::Box box = r.bounds();
    const std::size_t u = (r.axis + 1) % 3;
    const std::size_t v = (r.axis + 2) % 3;
    std::vector<scene::VertexIndex> corners;
    for (const auto& [high_u, high_v] :
         {std::pair{false, false}, {true, false}, {true, true}, {false, true}}) {
      scene::PolyPoint corner = box.low;
      if (high_u) corner[u] = box.high[u];
      if (high_v) corner[v] = box.high[v];
      corners.push_back(static_cast<scene::VertexIndex>(scene.vertices.size()));
      scene.vertices.push_back(corner);
    }
    if (!forwards) std::reverse(corners.begin(), corners.end());
    return corners;
  };
  scene::PolyFace face{ring(wall, true), {}};
  if (hole != nullptr) face.holes.push_back(ring(*hole, false));
  scene.bodies.push_back({"", true, {face}});
}

inline void add_walls_around(scene::PolyScene& scene, const geometry::Box& box) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    add_wall(scene, face_of(box, axis, false));
    add_wall(scene, face_of(box, axis, true));
  }
}

// Portals at z = depth(i), i = 1 .. portals.size(); the last cell ends at `end`.
inline HardCase corridor(const std::vector<geometry::Rectangle>& portals, std::int32_t end,
                         std::int32_t half = 50) {
  HardCase hard{{}, {{-half, -half, -100}, {half, half, end}}, {}, {}, {}};
  add_walls_around(hard.scene, hard.outer);
  geometry::Box room = hard.outer;
  for (std::size_t i = 0; i < portals.size(); ++i) {
    room.high[2] = portals[i].at;
    hard.cells.push_back(room);
    add_wall(hard.scene, face_of(room, 2, true), &portals[i]);
    const auto below = static_cast<scene::CellNumber>(i);
    hard.openings.push_back({portals[i], below, below + 1});
    room.low[2] = portals[i].at;
  }
  room.high[2] = end;
  hard.cells.push_back(room);
  return hard;
}

inline geometry::Rectangle portal(std::int32_t z, geometry::Span x, geometry::Span y) {
  return {2, z, {x, y}};
}

}  // namespace sightline::algorithms
