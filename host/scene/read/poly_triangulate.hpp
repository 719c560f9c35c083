// A face, with or without holes, as triangles between its own vertices (ear clipping, every decision exact).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

// Faces with more vertices than this are not split: to cut off an ear is to look at every vertex for every
// ear tried, so that the work may grow with the cube. With holes it is every edge for every bridge tried too.
inline constexpr std::size_t most_split_vertices = 4096;
inline constexpr std::size_t most_split_vertices_with_holes = 1024;

// Twice the area vector of a ring (each component below 2^39 if the ring is simple); also of one that is not
// planar.
[[nodiscard]] std::array<std::int64_t, 3> ring_normal(const std::vector<PolyPoint>& vertices,
                                                      std::span<const VertexIndex> ring);

// The triangles turn as the outline does. Empty if the face, looked at along the largest component of its
// ring_normal or another one that is not far below it, is not a simple ring with simple holes in it, or has too many vertices.
[[nodiscard]] std::optional<std::vector<std::array<VertexIndex, 3>>> triangulate(
    const std::vector<PolyPoint>& vertices, const PolyFace& face, std::size_t most_with_holes = most_split_vertices_with_holes);

}  // namespace sightline::scene
