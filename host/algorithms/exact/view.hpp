// A mesh seen by one camera: points relative to the eye, their image positions, and the faces that can occlude.
//
// Image positions are rounded to a raster of 2^15 by 2^15 steps, depths to single precision. Both roundings keep the
// order: images that overlap still overlap, and what is farther does not become nearer. They only serve to skip pairs of
// an edge and a face that cannot matter.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "host/algorithms/exact/edge_mesh.hpp"
#include "host/picture/edge_choice.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::exact {

// A plane. Its normal has 39 bits, its values 60.
struct Plane {
  Vector normal{};
  std::int64_t offset = 0;

  [[nodiscard]] std::int64_t at(const Vector& p) const { return geometry::dot(normal, p) - offset; }
};

// A point (q a - p b) / (a - b) relative to the eye.
struct LinePoint {
  Vector p{};
  Vector q{};
  std::int64_t a = 0;  // greater than b
  std::int64_t b = 0;

  [[nodiscard]] std::int64_t weight() const { return a - b; }  // 61 bits
  // For a quantity linear in space, with 60-bit values at p and q: its value at the point, times the weight.
  [[nodiscard]] geometry::Int128 between(std::int64_t at_p, std::int64_t at_q) const {
    return geometry::Int128{at_q} * a - geometry::Int128{at_p} * b;
  }
  [[nodiscard]] geometry::Int128 value(const Plane& plane) const { return between(plane.at(p), plane.at(q)); }
};

inline constexpr std::uint16_t last_step = (1 << 15) - 1;

// A rectangle of raster steps, ends included. Points outside the raster are moved to its border.
struct ImageBounds {
  std::array<std::uint16_t, 2> low{last_step, last_step};
  std::array<std::uint16_t, 2> high{};
};

struct ViewPoint {
  std::array<std::uint16_t, 2> seen{};  // raster steps; only of points in front of the eye
  std::uint32_t depth = 0;              // ascends with forward . at; 0: not in front of the eye, in perspective
};

// Three integers of 20 bits each.
class PackedPoint {
 public:
  PackedPoint() = default;
  explicit PackedPoint(const geometry::Point3& p) {
    const auto bits = [&p](std::size_t axis) { return static_cast<std::uint64_t>(p[axis]) & ((std::uint64_t{1} << 20) - 1); };
    bits_ = bits(0) | bits(1) << 20 | bits(2) << 40;
  }
  [[nodiscard]] Vector unpacked() const {
    return {static_cast<std::int64_t>(bits_ << 44) >> 44, static_cast<std::int64_t>(bits_ << 24) >> 44,
            static_cast<std::int64_t>(bits_ << 4) >> 44};
  }

 private:
  std::uint64_t bits_ = 0;
};

// A face that can hide something: a face of a solid turned to the eye, or of a sheet not seen edge-on. Fills one cache
// line.
struct alignas(64) Occluder {
  // The face's plane, positive beyond the face.
  PackedNormal beyond;
  std::int64_t offset = 0;
  // Relative to the eye, if the face has one ring of three or four corners; of three, the last is repeated.
  std::array<PackedPoint, 4> corners{};
  std::uint32_t face : 31 = 0;  // of the mesh
  std::uint32_t few_corners : 1 = 0;

  [[nodiscard]] Plane plane_beyond() const { return {beyond.unpacked(), offset}; }
};

struct View {
  const EdgeMesh* mesh = nullptr;
  std::span<const picture::LineEdge> edges;  // all of the mesh, or the chosen ones
  std::uint32_t first_line = 0;              // number of the first edge that is a crossing
  bool perspective = true;
  geometry::Point3 eye{};
  Vector forward{};
  std::array<Vector, 2> axes{};  // right, up
  std::vector<ViewPoint> points;  // by vertex of the mesh
  std::vector<std::uint8_t> drawn;  // 1 for edges that are neither hidden by their own solid nor behind the eye
  std::vector<Occluder> occluders;
  std::vector<ImageBounds> occluder_bounds;
  std::vector<std::uint32_t> occluder_depths;  // of each occluder's nearest corner

  // Relative to the eye.
  [[nodiscard]] geometry::Point3 at(std::uint32_t vertex) const {
    const geometry::Point3& p = mesh->vertices[vertex];
    return {p[0] - eye[0], p[1] - eye[1], p[2] - eye[2]};
  }
  [[nodiscard]] bool before_eye(const ViewPoint& p) const { return !perspective || p.depth != 0; }
  // Of an edge with an end in front of the eye. The bounds of a crossing are one step larger, because its ends are rounded.
  [[nodiscard]] ImageBounds bounds_of(std::uint32_t number) const {
    const picture::LineEdge& edge = edges[number];
    if (number >= first_line) return bounds_of_line(edge);
    ImageBounds bounds;
    extend(bounds, edge.from, edge.to);
    if (before_eye(points[edge.to])) extend(bounds, points[edge.to]);
    return bounds;
  }
  // Of an edge that is a crossing.
  [[nodiscard]] const MeshLine& line_of(const picture::LineEdge& edge) const { return mesh->lines[(edge.from - mesh->first_line_vertex()) / 2]; }
  [[nodiscard]] LinePoint line_point(const LineEnd& end) const {
    return {geometry::difference(end.p, eye), geometry::difference(end.q, eye), end.a, end.b};
  }
  // Extends the bounds by the part in front of the eye of the segment from vertex p to vertex q, except q itself.
  void extend(ImageBounds& bounds, std::uint32_t p, std::uint32_t q) const {
    const bool p_before = before_eye(points[p]);
    if (p_before) extend(bounds, points[p]);
    if (p_before != before_eye(points[q])) extend_to_infinity(bounds, p_before ? p : q, p_before ? q : p);
  }

 private:
  static void extend(ImageBounds& bounds, const ViewPoint& p) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      bounds.low[axis] = bounds.low[axis] < p.seen[axis] ? bounds.low[axis] : p.seen[axis];
      bounds.high[axis] = bounds.high[axis] > p.seen[axis] ? bounds.high[axis] : p.seen[axis];
    }
  }
  [[nodiscard]] ImageBounds bounds_of_line(const picture::LineEdge& line) const;
  void extend_to_infinity(ImageBounds& bounds, std::uint32_t seen, std::uint32_t behind) const;
};

// `chosen`, if given, lists in ascending order the only edges to draw, and outlives the view. Uses up to `jobs` threads.
[[nodiscard]] View make_view(const EdgeMesh& mesh, const scene::PolyCamera& camera,
                             const picture::ChosenEdges* chosen = nullptr, unsigned jobs = 1);

}  // namespace sightline::algorithms::exact
