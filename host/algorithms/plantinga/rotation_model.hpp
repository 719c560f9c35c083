// A polyhedral scene laid out for the study of its rotation about the y axis: edges, faces as rings of
// corners, and for every edge the faces that may ever hide any of it.
//
// Occlusion: only parts on the front of a face's plane may hide the face, and nothing behind it does (the
// paper's sentence has it the wrong way round, its figure right); so a face f may hide of an edge e only what
// of e is behind the plane of f, and that does not change as the scene turns. Faces of solids hide by their
// front, which is enough for closed ones; faces of sheets by either side and are here twice.
//
// Sizes, coordinates below 2^18: face normals 39 bits, a point against a plane 60 bits.
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
  std::uint32_t next = 0;  // the other end of the side, counted from the first corner of the face
  bool with_edge = true;   // the side runs as the edge does, from its lower vertex to its higher
};

struct RotatedFace {
  std::uint32_t first_corner = 0;
  std::uint32_t corner_count = 0;
  bool sheet = false;
  bool horizontal = false;  // edge-on always
  Vector3 normal{};         // twice the area; out of a solid
  std::int64_t low = 0;     // of y
  std::int64_t high = 0;
};

// A face at an edge: faces that pass the edge in opposite directions turn the same side outwards.
struct Incidence {
  FaceIndex face = 0;
  bool with_edge = true;
};

// A face and the side of it, +1 for the one its normal points to, from which it hides some of an edge.
struct Occluder {
  FaceIndex face = 0;
  std::int8_t side = 1;
  // Ends of the edge against the plane, times the side: negative behind it. At least one is.
  std::int64_t from = 0;
  std::int64_t to = 0;
};

class RotationModel {
 public:
  // The scene is a checked one (precondition).
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
  // Faces that may hide some of the edge from somewhere.
  [[nodiscard]] std::vector<Occluder> occluders_of(EdgeIndex edge) const;
  // Of vertices, faces and which of them are sheets: what an event file belongs to.
  [[nodiscard]] std::uint64_t fingerprint() const { return fingerprint_; }

 private:
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
