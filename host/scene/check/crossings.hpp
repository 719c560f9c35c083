// Where bodies pass through each other, or through themselves: the lines that two faces have in common within both.
//
// Two faces cross along a line if near every inner point of it each face lies on both sides of the other's plane.
// So shared and touching vertices and edges are no crossings, nor are faces in one plane, nor an edge that lies on a
// face without going through it. Found are the pieces of the common line of the two planes that are inside of both
// faces on either side; their ends are points in which an edge of one face meets the plane of the other (face_cut.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

struct Crossing {
  std::uint32_t face_a = 0;  // counted over all bodies from 0, a < b
  std::uint32_t face_b = 0;
  std::array<CutPoint, 2> ends{};  // in the direction of the cross product of the faces' normals

  friend bool operator==(const Crossing&, const Crossing&) = default;
};

// Of a checked scene, ascending by the faces; at most `most`. Those between faces of one surface are left out, and in a mesh
// those that are shorter than two steps, as rounding a file makes some. Near-linear in the faces unless many of
// them are near each other. With `jobs` threads; the result is the same.
[[nodiscard]] std::vector<Crossing> crossings_of(const PolyScene& scene, std::size_t most = std::numeric_limits<std::size_t>::max(),
                                                 unsigned jobs = 1);

// The same scene with its crossings. A body that passes through itself is a sheet in it: behind the crossing its faces may be
// turned the wrong side out, and then those turned away from the eye are seen and hide others.
[[nodiscard]] PolyScene with_crossings(PolyScene scene, unsigned jobs = 1);

}  // namespace sightline::scene
