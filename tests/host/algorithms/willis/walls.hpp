// Walls in plan, as in the paper and in the list of hard cases, and prisms over any outline.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "host/algorithms/willis/model.hpp"
#include "host/algorithms/willis/surface.hpp"
#include "host/scene/model/poly_builder.hpp"

namespace sightline::algorithms::willis {

using PlanPoint = std::array<std::int32_t, 2>;

// From a to b; visible from the right-hand side of the direction from a to b.
inline Surface wall(PlanPoint a, PlanPoint b, std::uint32_t face = 0) {
  Surface s;
  s.points = {on_lattice({a[0], 0, a[1]}), on_lattice({b[0], 0, b[1]})};
  s.plane.normal = {std::int64_t{b[1]} - a[1], 0, std::int64_t{a[0]} - b[0]};
  s.plane.offset = s.plane.normal[0] * a[0] + s.plane.normal[2] * a[1];
  s.face = s.body = face;
  s.high = 1;
  return s;
}

inline Surface flip(const Surface& s) {
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

}  // namespace sightline::algorithms::willis
