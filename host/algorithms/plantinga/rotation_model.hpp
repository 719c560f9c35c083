// A polyhedral scene prepared for the analysis of its rotation about the y axis: edges, faces as rings of corners, and
// for every edge the faces that may ever hide part of it.
//
// Occlusion: only parts in front of a face's plane may hide the face (the paper's sentence says the opposite, its figure
// is right). So a face f may hide only the part of an edge e that is behind the plane of f, which does not change as the
// scene turns. Faces of solids hide by their front, which suffices for closed solids; faces of sheets hide from both
// sides and are stored twice.
//
// Sizes, with coordinates below 2^18: face normals 39 bits, the value of a face's plane at a point 60 bits.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "host/algorithms/plantinga/potential_events.hpp"
#include "host/picture/line_picture.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::plantinga {

using EdgeIndex = std::uint32_t;
using FaceIndex = std::uint32_t;

// A corner of a face and the side that leaves it.
struct Corner {
  std::uint32_t vertex = 0;
  EdgeIndex side = 0;
  std::uint32_t next = 0;  // the other end of the side, relative to the first corner of the face
  bool with_edge = true;   // the side runs from its edge's lower vertex to its higher one
};

struct RotatedFace {
  std::uint32_t first_corner = 0;
  std::uint32_t corner_count = 0;
  bool sheet = false;
  bool horizontal = false;  // always edge-on
  Vector3 normal{};         // twice the area; outwards for a solid
  std::int64_t low = 0;     // least and greatest y
  std::int64_t high = 0;
};

// A face at an edge. Faces that pass the edge in opposite directions have the same side outwards.
struct Incidence {
  FaceIndex face = 0;
  bool with_edge = true;
};

// A face that hides part of an edge, and the side of it from which it does: +1 for the side its normal points to.
struct Occluder {
  FaceIndex face = 0;
  std::int8_t side = 1;
  // Values of the plane at the edge's ends, times the side: negative behind it. At least one is negative.
  std::int64_t from = 0;
  std::int64_t to = 0;
};

// The sides and corners of faces, each once, ascending.
struct FaceBorders {
  std::vector<EdgeIndex> edges;
  std::vector<scene::VertexIndex> vertices;
};

class RotationModel {
 public:
  // Precondition: the scene is checked.
  explicit RotationModel(const scene::PolyScene& scene);

  [[nodiscard]] const std::vector<Vector3>& vertices() const { return vertices_; }
  [[nodiscard]] const std::vector<picture::LineEdge>& edges() const { return edges_; }
  [[nodiscard]] const std::vector<RotatedFace>& faces() const { return faces_; }
  [[nodiscard]] std::span<const Corner> corners(FaceIndex face) const {
    return {corners_.data() + faces_[face].first_corner, faces_[face].corner_count};
  }
  [[nodiscard]] std::span<const Incidence> faces_at(EdgeIndex edge) const {
    return {incidences_.data() + incidence_start_[edge], incidences_.data() + incidence_start_[edge + 1]};
  }
  [[nodiscard]] std::span<const EdgeIndex> edges_at(scene::VertexIndex vertex) const {
    return {fan_.data() + fan_start_[vertex], fan_.data() + fan_start_[vertex + 1]};
  }
  [[nodiscard]] Segment segment(EdgeIndex edge) const {
    return {vertices_[edges_[edge].from], vertices_[edges_[edge].to]};
  }
  // The faces that hide part of the edge from some direction without a y component.
  [[nodiscard]] std::vector<Occluder> occluders_of(EdgeIndex edge) const;
  // The faces that hide part of the edge from somewhere.
  [[nodiscard]] std::vector<Occluder> occluders_from_anywhere(EdgeIndex edge) const;
  [[nodiscard]] FaceBorders borders_of(std::span<const Occluder> faces) const;
  // A hash of the vertices, the faces and which of them are sheets: identifies the model of an event file.
  [[nodiscard]] std::uint64_t fingerprint() const { return fingerprint_; }

 private:
  void append_occluder(const Segment& edge, FaceIndex face, std::vector<Occluder>& found) const;
  void append_ring(std::span<const scene::VertexIndex> ring, std::uint32_t first_corner);
  void append_face(const scene::PolyFace& given, bool sheet);
  void number_edges();
  void gather();
  void take_fingerprint();

  std::vector<Vector3> vertices_;
  std::vector<picture::LineEdge> edges_;
  std::vector<Corner> corners_;
  std::vector<RotatedFace> faces_;
  std::vector<std::uint32_t> incidence_start_;
  std::vector<Incidence> incidences_;
  std::vector<std::uint32_t> fan_start_;
  std::vector<EdgeIndex> fan_;
  std::uint64_t fingerprint_ = 0;
};

}  // namespace sightline::algorithms::plantinga
