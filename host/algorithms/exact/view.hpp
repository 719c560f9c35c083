// A mesh for one camera: points relative to the eye, planes of sight, the faces that can occlude
// anything.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host/algorithms/exact/edge_mesh.hpp"
#include "host/picture/edge_choice.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::exact {

// The plane through the eye and an edge. Positive to the left of the edge, as seen. Normal 39 bits,
// values 60.
struct Plane {
  Vector normal{};
  std::int64_t offset = 0;

  [[nodiscard]] std::int64_t at(const Vector& p) const { return geometry::dot(normal, p) - offset; }
};

// Bounds in the image, as quotients right / forward and up / forward, or right and up themselves.
struct ImageBounds {
  std::array<double, 2> low{};
  std::array<double, 2> high{};

  [[nodiscard]] bool meets(const ImageBounds& b) const {
    return low[0] <= b.high[0] && b.low[0] <= high[0] && low[1] <= b.high[1] && b.low[1] <= high[1];
  }
};

// A face that can hide something: of a solid and turned to the eye, or of a sheet and not edge-on.
struct Occluder {
  std::uint32_t first_corner = 0;
  std::uint32_t corner_count = 0;
  Plane beyond;            // of the face; positive beyond it
  std::int64_t depth = 0;  // of its nearest corner
  ImageBounds bounds;
  std::uint32_t surface = 0;
};

struct View {
  const EdgeMesh* mesh = nullptr;
  bool perspective = true;
  std::vector<Vector> points;        // vertices relative to the eye
  std::vector<std::int64_t> depths;  // forward . point
  std::vector<Plane> planes;         // of each edge
  std::vector<ImageBounds> bounds;   // of each edge, where it is before the eye
  std::vector<std::uint8_t> drawn;   // 1 for edges that are not hidden by their own solid or behind the eye
  std::vector<Occluder> occluders;   // ascending by depth
};

// With `chosen`, an ascending choice of the mesh's edges, no others are drawn.
[[nodiscard]] View make_view(const EdgeMesh& mesh, const scene::PolyCamera& camera,
                             const picture::ChosenEdges* chosen = nullptr);

}  // namespace sightline::algorithms::exact
