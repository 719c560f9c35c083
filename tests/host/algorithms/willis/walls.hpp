// Walls in plan, as the paper and the list of hard cases have them, and the town of rotated prisms.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "host/algorithms/willis/distance.hpp"
#include "host/algorithms/willis/model.hpp"
#include "host/algorithms/willis/surface.hpp"
#include "host/scene/generate_random.hpp"
#include "host/scene/poly_builder.hpp"

namespace sightline::algorithms::willis {

using PlanPoint = std::array<std::int32_t, 2>;

// From a to b; seen from the right-hand side of someone who walks from a to b.
inline Surface wall(PlanPoint a, PlanPoint b, std::uint32_t face = 0) {
  Surface s;
  s.points = {on_lattice({a[0], 0, a[1]}), on_lattice({b[0], 0, b[1]})};
  s.plane.normal = {std::int64_t{b[1]} - a[1], 0, std::int64_t{a[0]} - b[0]};
  s.plane.offset = s.plane.normal[0] * a[0] + s.plane.normal[2] * a[1];
  s.face = s.body = face;
  s.high = 1;
  return s;
}

inline Surface turned(const Surface& s) {
  Surface other = s;
  other.points = {s.points[1], s.points[0]};
  other.plane = {geometry::negated(s.plane.normal), -s.plane.offset};
  return other;
}

// A right prism over a counterclockwise ring of (x, z), y from 0 to height.
inline void add_prism(scene::PolyBuilder& builder, std::string name, std::span<const PlanPoint> ring,
                      std::int32_t height) {
  scene::PolyBody body;
  body.name = std::move(name);
  scene::PolyFace floor;
  scene::PolyFace roof;
  const std::size_t n = ring.size();
  const auto vertex = [&](std::size_t i, std::int32_t y) {
    return builder.vertex({ring[i % n][0], y, ring[i % n][1]});
  };
  for (std::size_t i = 0; i < n; ++i) {
    floor.outline.push_back(vertex(i, 0));
    roof.outline.push_back(vertex(n - 1 - i, height));
    // x, y, z is right-handed, so that counterclockwise in (x, z) is clockwise seen from above.
    body.faces.push_back({{vertex(i, 0), vertex(i, height), vertex(i + 1, height), vertex(i + 1, 0)}, {}});
  }
  body.faces.push_back(std::move(floor));
  body.faces.push_back(std::move(roof));
  builder.scene().bodies.push_back(std::move(body));
}

// n rotated rectangles on a square of `side`, none nearer than `gap` to another: the town on which the figures
// of the specification were measured, in integers.
inline scene::PolyScene prism_town(std::size_t n, std::int32_t side, std::int32_t gap, std::uint64_t seed) {
  scene::SceneRandom random(seed);
  scene::PolyBuilder builder;
  std::vector<Surface> taken;
  constexpr std::array<PlanPoint, 8> turns{{{4, 3}, {3, 4}, {12, 5}, {5, 12}, {1, 0}, {15, 8}, {24, 7}, {1, 1}}};
  std::size_t placed = 0;
  while (placed < n) {
    const PlanPoint turn = turns[static_cast<std::size_t>(random.mod(turns.size()))];
    const std::int32_t unit = side / 100;
    const std::int32_t scale = turn[0] + turn[1];
    const auto length = [&] { return (3 + random.mod(11)) * unit / scale; };
    const std::int32_t w = length();
    const std::int32_t h = length();
    const PlanPoint o{random.mod(static_cast<std::uint64_t>(side)), random.mod(static_cast<std::uint64_t>(side))};
    const auto at = [&](std::int32_t u, std::int32_t v) {
      return PlanPoint{o[0] + u * turn[0] - v * turn[1], o[1] + u * turn[1] + v * turn[0]};
    };
    const std::array<PlanPoint, 4> ring{at(0, 0), at(w, 0), at(w, h), at(0, h)};
    std::vector<Surface> walls;
    for (std::size_t i = 0; i < 4; ++i) walls.push_back(wall(ring[i], ring[(i + 1) % 4]));
    // Every wall and its diagonals, so that one inside the other is found, too.
    walls.push_back(wall(ring[0], ring[2]));
    walls.push_back(wall(ring[1], ring[3]));
    const std::uint64_t least = static_cast<std::uint64_t>(gap) * lattice_unit;
    const bool too_near = std::any_of(walls.begin(), walls.end(), [&](const Surface& s) {
      return std::any_of(taken.begin(), taken.end(),
                         [&](const Surface& t) { return meet(s, t) || within(s, t, least * least); });
    });
    if (too_near) continue;
    taken.insert(taken.end(), walls.begin(), walls.end());
    add_prism(builder, "prism " + std::to_string(placed), ring, 10 * unit);
    ++placed;
  }
  scene::PolyScene scene = builder.take();
  scene.name = "prisms";
  return scene;
}

}  // namespace sightline::algorithms::willis
