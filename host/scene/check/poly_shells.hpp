// The edges of a body's faces, and which faces they connect.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "host/geometry/integer.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

// An edge as one face has it.
struct FaceEdge {
  VertexIndex low = 0;
  VertexIndex high = 0;
  std::size_t face = 0;
  bool upwards = false;  // passed from low to high

  [[nodiscard]] bool same_edge(const FaceEdge& other) const { return low == other.low && high == other.high; }
};

// Of outlines and holes, sorted by low, high and face.
[[nodiscard]] std::vector<FaceEdge> face_edges(const PolyBody& body);

// Every edge belongs to exactly two faces, which pass it in opposite directions.
[[nodiscard]] bool is_closed(const std::vector<FaceEdge>& edges);

// For each face the number of its part, from 0 in the order of the parts' first faces; two faces are in the
// same part if a chain of faces with common edges joins them.
[[nodiscard]] std::vector<std::size_t> connected_faces(const PolyBody& body,
                                                       const std::vector<FaceEdge>& edges);

// Six times the volume of the cone from the origin over the faces' outlines less their holes: summed over a
// closed surface, what it encloses, positive if it faces outwards.
[[nodiscard]] geometry::Int128 enclosed_volume(const std::vector<PolyPoint>& vertices, std::span<const VertexIndex> outline);
[[nodiscard]] geometry::Int128 enclosed_volume(const std::vector<PolyPoint>& vertices, const PolyFace& face);
[[nodiscard]] geometry::Int128 enclosed_volume(const std::vector<PolyPoint>& vertices, const PolyBody& body);

}  // namespace sightline::scene
