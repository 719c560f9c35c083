// The hard cases of Jones's algorithm that concern an exact build, as scenes with their cells and openings.
//
// J1 to J17 are numbered as in the suite's list of hard cases. The eye is at the origin and looks along z
// unless said otherwise. Corridor C(k): cell 0 is z -100..100, cell i is z 100i..100(i+1), |x| and |y| at
// most 50; between cells i-1 and i a wall with a portal at z = 100i. Walls are sheets; the outer box is the
// corridor.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "host/scene/poly_scene.hpp"
#include "tests/host/algorithms/jones/box_complex.hpp"

namespace sightline::algorithms {

struct HardCase {
  std::string id;
  std::string what;
  scene::PolyScene scene;
  geometry::Box outer;
  std::vector<geometry::Box> cells;
  std::vector<BoxOpening> openings;
  scene::PolyCamera camera;
  std::uint64_t cells_seen = 0;  // expected
  std::uint64_t most_sides = 0;  // of a mask, expected; 0: not said

  [[nodiscard]] scene::CellComplex complex() const { return complex_of_boxes(scene, outer, cells, openings); }
};

// A wall without thickness, perhaps with a hole strictly inside it.
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
inline HardCase corridor(std::string id, std::string what, const std::vector<geometry::Rectangle>& portals,
                         std::int32_t end, std::int32_t half = 50) {
  HardCase hard{
      std::move(id), std::move(what), {}, {{-half, -half, -100}, {half, half, end}}, {}, {}, {}, 0, 0};
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

inline HardCase edge_on_portal() {
  HardCase hard{"J1", "edge-on portal", {}, {{-50, -50, -100}, {50, 50, 100}}, {}, {}, {}, 2, 4};
  hard.cells = {
      {{-50, -50, -100}, {50, 50, 40}}, {{-50, -50, 40}, {0, 50, 100}}, {{0, -50, 40}, {50, 50, 100}}};
  const geometry::Rectangle door = {0, 0, {geometry::Span{-5, 5}, geometry::Span{50, 80}}};
  hard.openings = {{{2, 40, {geometry::Span{-50, 0}, geometry::Span{-50, 50}}}, 0, 1}, {door, 1, 2}};
  add_walls_around(hard.scene, hard.outer);
  add_wall(hard.scene, {2, 40, {geometry::Span{0, 50}, geometry::Span{-50, 50}}});
  add_wall(hard.scene, {0, 0, {geometry::Span{-50, 50}, geometry::Span{40, 100}}}, &door);
  return hard;
}

inline HardCase eye_in_portal() {
  HardCase hard = corridor("J2", "eye in a portal", {portal(0, {-20, 20}, {-20, 20})}, 100);
  hard.cells_seen = 2;
  return hard;
}

inline HardCase portal_partly_behind() {
  HardCase hard{"J13", "portal partly behind the eye", {}, {{-30, -50, -100}, {60, 50, 100}}, {}, {}, {}, 2,
                0};
  hard.cells = {{{-30, -50, -100}, {30, 50, 100}}, {{30, -50, -100}, {60, 50, 100}}};
  const geometry::Rectangle door = {0, 30, {geometry::Span{-20, 20}, geometry::Span{-50, 50}}};
  hard.openings = {{door, 0, 1}};
  add_walls_around(hard.scene, hard.outer);
  add_wall(hard.scene, {0, 30, {geometry::Span{-50, 50}, geometry::Span{-100, 100}}}, &door);
  return hard;
}

// Three cells around a pillar, x 10..20, z 20..30: beside it to the left, beyond it, and beside it to the
// right.
inline HardCase around_a_pillar() {
  HardCase hard{"J15", "cells in a circle", {}, {{-50, -50, -100}, {50, 50, 100}}, {}, {}, {}, 3, 0};
  hard.cells = {{{-50, -50, -100}, {10, 50, 100}},
                {{10, -50, 30}, {50, 50, 100}},
                {{20, -50, -100}, {50, 50, 30}},
                {{10, -50, -100}, {20, 50, 20}}};
  const geometry::Span height{-50, 50};
  hard.openings = {{{0, 10, {height, geometry::Span{30, 100}}}, 0, 1},
                   {{2, 30, {geometry::Span{20, 50}, height}}, 2, 1},
                   {{0, 20, {height, geometry::Span{-100, 20}}}, 3, 2},
                   {{0, 10, {height, geometry::Span{-100, 20}}}, 0, 3}};
  add_walls_around(hard.scene, hard.outer);
  const geometry::Box pillar{{10, -50, 20}, {20, 50, 30}};
  for (const std::size_t axis : {std::size_t{0}, std::size_t{2}}) {
    for (const bool high : {false, true}) add_wall(hard.scene, face_of(pillar, axis, high));
  }
  hard.cells_seen = 4;
  return hard;
}

// All those whose picture is that of `exact`.
inline std::vector<HardCase> hard_cases() {
  std::vector<HardCase> cases = {edge_on_portal(), eye_in_portal()};
  const auto add = [&cases](HardCase hard, std::uint64_t cells_seen, std::uint64_t most_sides) {
    hard.cells_seen = cells_seen;
    hard.most_sides = most_sides;
    cases.push_back(std::move(hard));
  };
  const geometry::Span wide{-20, 20};
  add(corridor("J5", "windows share a side", {portal(100, {-20, 0}, wide), portal(200, {0, 20}, wide)}, 300),
      2, 4);
  add(corridor("J5 narrow", "windows share a strip",
               {portal(100, {-20, 1}, wide), portal(200, {0, 20}, wide)}, 300),
      3, 4);
  add(corridor("J5 corner", "windows share a point",
               {portal(100, {-20, 0}, {-20, 0}), portal(200, {0, 20}, {0, 20})}, 300),
      2, 4);
  add(corridor("J6", "corner on a corner",
               {portal(100, {-10, 10}, {-10, 10}), portal(200, {-20, 20}, {-20, 20})}, 300),
      3, 4);
  std::vector<geometry::Rectangle> grazing;
  for (std::int32_t i = 1; i <= 39; ++i) grazing.push_back(portal(100 * i, {i, 40}, wide));
  add(corridor("J7", "portals along a grazing ray", grazing, 4000), 40, 4);
  std::vector<geometry::Rectangle> nested;
  for (std::int32_t i = 1; i <= 1000; ++i) nested.push_back(portal(100 * i, wide, wide));
  add(corridor("J8", "a thousand rooms", nested, 100100), 1001, 4);
  add(corridor("J11", "tiny window", {portal(131071, {0, 1}, {0, 1})}, 131080), 2, 4);
  add(corridor("J12", "far beside the eye", {portal(1, {-131071, 131071}, {-1, 1})}, 50, 140000), 2, 4);
  cases.push_back(portal_partly_behind());
  cases.push_back(around_a_pillar());
  return cases;
}

}  // namespace sightline::algorithms
