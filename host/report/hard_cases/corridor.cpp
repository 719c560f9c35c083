#include "host/report/hard_cases/corridor.hpp"

#include <cstddef>

namespace sightline::harness::report {

namespace {

using geometry::Span;

// The wall around a portal: above and below it over the whole width, and beside it.
void add_wall(scene::CellScene& scene, const Portal& portal) {
  const Span width = scene.outer.span(0);
  const Span height = scene.outer.span(1);
  scene.walls.push_back({2, portal.z, {width, Span{height.low, portal.y.low}}});
  scene.walls.push_back({2, portal.z, {width, Span{portal.y.high, height.high}}});
  scene.walls.push_back({2, portal.z, {Span{width.low, portal.x.low}, portal.y}});
  scene.walls.push_back({2, portal.z, {Span{portal.x.high, width.high}, portal.y}});
}

scene::Opening opening_of(const Portal& portal, std::size_t below) {
  const auto& [z, x, y] = portal;
  const auto across = static_cast<std::int32_t>(x.length());
  const auto up = static_cast<std::int32_t>(y.length());
  return {{below, below + 1},
          {2, z, {x, y}},
          {{x.low, y.low, z}, {x.high, y.low, z}, {x.high, y.high, z}, {x.low, y.high, z}},
          {{true, 0, across}, {true, 1, up}, {true, 0, -across}, {true, 1, -up}}};
}

// The twelve edges of a room.
std::vector<scene::Line> edges_of(const geometry::Box& room) {
  std::vector<scene::Line> lines;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [u, v] = geometry::other_axes(axis);
    for (const bool high_u : {false, true}) {
      for (const bool high_v : {false, true}) {
        scene::Line line{room.low, room.low};
        line.from[u] = line.to[u] = high_u ? room.high[u] : room.low[u];
        line.from[v] = line.to[v] = high_v ? room.high[v] : room.low[v];
        line.to[axis] = room.high[axis];
        lines.push_back(line);
      }
    }
  }
  return lines;
}

}  // namespace

scene::CellScene corridor(const std::vector<Portal>& portals, std::int32_t end, std::int32_t half) {
  scene::CellScene scene;
  scene.name = "corridor";
  scene.outer = {{-half, -half, -100}, {half, half, end}};
  geometry::Box room = scene.outer;
  for (const Portal& portal : portals) {
    room.high[2] = portal.z;
    add_wall(scene, portal);
    scene.openings.push_back(opening_of(portal, scene.cells.size()));
    scene.cells.push_back({room, edges_of(room)});
    room.low[2] = portal.z;
  }
  room.high[2] = end;
  scene.cells.push_back({room, edges_of(room)});
  return scene;
}

}  // namespace sightline::harness::report
