// A mesh for one camera: points relative to the eye, where they are seen, the faces that can occlude anything.
//
// Where a point is seen is rounded to steps of a raster of 2^15 by 2^15 over the image, and how far it is to single
// precision. Both roundings keep the order: what overlaps overlaps there, what is farther is not nearer there. So they
// say which pairs of an edge and a face may be left out, and nothing else.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host/algorithms/exact/edge_mesh.hpp"
#include "host/picture/edge_choice.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::exact {

// A plane: normal 39 bits, values 60.
struct Plane {
  Vector normal{};
  std::int64_t offset = 0;

  [[nodiscard]] std::int64_t at(const Vector& p) const { return geometry::dot(normal, p) - offset; }
};

inline constexpr std::uint16_t last_step = (1 << 15) - 1;

// A rectangle of the image in steps, ends included. Points beside the raster belong to its border.
struct ImageBounds {
  std::array<std::uint16_t, 2> low{last_step, last_step};
  std::array<std::uint16_t, 2> high{};
};

struct ViewPoint {
  geometry::Point3 at{};               // relative to the eye
  std::array<std::uint16_t, 2> seen{};  // steps, of what is before the eye
  std::uint32_t depth = 0;              // ascends with forward . at; 0: not before the eye of a perspective
};

// A face that can hide something: of a solid and turned to the eye, or of a sheet and not edge-on.
struct Occluder {
  Plane beyond;  // of the face; positive beyond it
  // Relative to the eye, of a face of one ring of three or four corners: three with the last one twice.
  std::array<geometry::Point3, 4> corners{};
  std::uint32_t face = 0;  // of the mesh
  bool few_corners = false;
};

struct View {
  const EdgeMesh* mesh = nullptr;
  bool perspective = true;
  Vector forward{};
  std::array<Vector, 2> axes{};  // right, up
  std::vector<ViewPoint> points;
  std::vector<std::uint8_t> drawn;  // 1 for edges that are not hidden by their own solid or behind the eye
  std::vector<Occluder> occluders;
  std::vector<ImageBounds> occluder_bounds;
  std::vector<std::uint32_t> occluder_depths;  // of the nearest corner of each

  [[nodiscard]] bool before_eye(const ViewPoint& p) const { return !perspective || p.depth != 0; }
  // Of an edge, one end of which is before the eye.
  [[nodiscard]] ImageBounds bounds_of(const picture::LineEdge& edge) const {
    ImageBounds bounds;
    extend(bounds, points[edge.from], points[edge.to]);
    if (before_eye(points[edge.to])) extend(bounds, points[edge.to]);
    return bounds;
  }
  // By what is before the eye of the segment from p to q, but for q itself.
  void extend(ImageBounds& bounds, const ViewPoint& p, const ViewPoint& q) const {
    if (before_eye(p)) extend(bounds, p);
    if (before_eye(p) != before_eye(q)) extend_to_infinity(bounds, before_eye(p) ? p : q, before_eye(p) ? q : p);
  }

 private:
  static void extend(ImageBounds& bounds, const ViewPoint& p) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      bounds.low[axis] = bounds.low[axis] < p.seen[axis] ? bounds.low[axis] : p.seen[axis];
      bounds.high[axis] = bounds.high[axis] > p.seen[axis] ? bounds.high[axis] : p.seen[axis];
    }
  }
  void extend_to_infinity(ImageBounds& bounds, const ViewPoint& seen, const ViewPoint& behind) const;
};

// With `chosen`, an ascending choice of the mesh's edges, no others are drawn. On so many threads.
[[nodiscard]] View make_view(const EdgeMesh& mesh, const scene::PolyCamera& camera,
                             const picture::ChosenEdges* chosen = nullptr, unsigned jobs = 1);

}  // namespace sightline::algorithms::exact
