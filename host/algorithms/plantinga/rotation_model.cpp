#include "host/algorithms/plantinga/rotation_model.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace sightline::algorithms::plantinga {
namespace {

using scene::VertexIndex;

picture::LineEdge edge_between(VertexIndex a, VertexIndex b) {
  return {std::min(a, b), std::max(a, b)};
}

}  // namespace

RotationModel::RotationModel(const scene::PolyScene& scene) {
  vertices_.reserve(scene.vertices.size());
  for (const scene::PolyPoint& v : scene.vertices) vertices_.push_back(geometry::vector_of(v));
  for (const scene::PolyBody& body : scene.bodies) {
    for (const scene::PolyFace& face : body.faces) append_face(face, body.sheet);
  }
  number_edges();
  gather();
  take_fingerprint();
}

void RotationModel::append_ring(std::span<const VertexIndex> ring, std::uint32_t first_corner) {
  const std::size_t first = corners_.size();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (ring[i] != ring[i + 1 == ring.size() ? 0 : i + 1]) corners_.push_back({ring[i], 0, 0, true});
  }
  const std::size_t count = corners_.size() - first;
  for (std::size_t i = 0; i < count; ++i) {
    corners_[first + i].next =
        static_cast<std::uint32_t>(first + (i + 1 == count ? 0 : i + 1) - first_corner);
  }
}

void RotationModel::append_face(const scene::PolyFace& given, bool sheet) {
  RotatedFace face;
  face.first_corner = static_cast<std::uint32_t>(corners_.size());
  face.sheet = sheet;
  append_ring(given.outline, face.first_corner);
  for (const auto& hole : given.holes) append_ring(hole, face.first_corner);
  face.corner_count = static_cast<std::uint32_t>(corners_.size()) - face.first_corner;
  if (face.corner_count == 0) return;
  const Vector3& about = vertices_[corners_[face.first_corner].vertex];
  std::array<std::uint64_t, 3> sum{};  // partial sums may wrap
  face.low = face.high = about[1];
  for (std::size_t i = face.first_corner; i < corners_.size(); ++i) {
    const Vector3& here = vertices_[corners_[i].vertex];
    const Vector3& next = vertices_[corners_[face.first_corner + corners_[i].next].vertex];
    const Vector3 part = geometry::cross(minus(here, about), minus(next, about));
    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += static_cast<std::uint64_t>(part[axis]);
    face.low = std::min(face.low, here[1]);
    face.high = std::max(face.high, here[1]);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) face.normal[axis] = static_cast<std::int64_t>(sum[axis]);
  face.horizontal = face.normal[0] == 0 && face.normal[2] == 0;
  faces_.push_back(face);
}

void RotationModel::number_edges() {
  const auto edge_of = [this](const RotatedFace& face, const Corner& corner) {
    return edge_between(corner.vertex, corners_[face.first_corner + corner.next].vertex);
  };
  for (FaceIndex f = 0; f < faces_.size(); ++f) {
    for (const Corner& corner : corners(f)) edges_.push_back(edge_of(faces_[f], corner));
  }
  std::sort(edges_.begin(), edges_.end());
  edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  for (const RotatedFace& face : faces_) {
    for (std::uint32_t i = face.first_corner; i < face.first_corner + face.corner_count; ++i) {
      const picture::LineEdge edge = edge_of(face, corners_[i]);
      corners_[i].side =
          static_cast<EdgeIndex>(std::lower_bound(edges_.begin(), edges_.end(), edge) - edges_.begin());
      corners_[i].with_edge = corners_[i].vertex == edge.from;
    }
  }
}

void RotationModel::gather() {
  incidence_start_.assign(edges_.size() + 1, 0);
  fan_start_.assign(vertices_.size() + 1, 0);
  for (const Corner& corner : corners_) ++incidence_start_[corner.side + 1];
  for (const picture::LineEdge& edge : edges_) {
    ++fan_start_[edge.from + 1];
    ++fan_start_[edge.to + 1];
  }
  for (std::size_t i = 1; i < incidence_start_.size(); ++i) incidence_start_[i] += incidence_start_[i - 1];
  for (std::size_t i = 1; i < fan_start_.size(); ++i) fan_start_[i] += fan_start_[i - 1];
  incidences_.resize(corners_.size());
  fan_.resize(2 * edges_.size());
  std::vector<std::uint32_t> fill(incidence_start_.begin(), incidence_start_.end() - 1);
  for (FaceIndex f = 0; f < faces_.size(); ++f) {
    for (const Corner& corner : corners(f)) incidences_[fill[corner.side]++] = {f, corner.with_edge};
  }
  fill.assign(fan_start_.begin(), fan_start_.end() - 1);
  for (EdgeIndex e = 0; e < edges_.size(); ++e) {
    fan_[fill[edges_[e].from]++] = e;
    fan_[fill[edges_[e].to]++] = e;
  }
}

FaceBorders RotationModel::borders_of(std::span<const Occluder> faces) const {
  FaceBorders borders;
  for (const Occluder& occluder : faces) {
    for (const Corner& corner : corners(occluder.face)) {
      borders.edges.push_back(corner.side);
      borders.vertices.push_back(corner.vertex);
    }
  }
  const auto once = [](auto& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  };
  once(borders.edges);
  once(borders.vertices);
  return borders;
}

std::vector<Occluder> RotationModel::occluders_of(EdgeIndex edge) const {
  const Segment segment_of = segment(edge);
  const auto [low, high] = std::minmax(segment_of.from[1], segment_of.to[1]);
  std::vector<Occluder> found;
  for (FaceIndex f = 0; f < faces_.size(); ++f) {
    const RotatedFace& face = faces_[f];
    if (!face.horizontal && face.high >= low && face.low <= high) append_occluder(segment_of, f, found);
  }
  return found;
}

std::vector<Occluder> RotationModel::occluders_from_anywhere(EdgeIndex edge) const {
  std::vector<Occluder> found;
  for (FaceIndex f = 0; f < faces_.size(); ++f) append_occluder(segment(edge), f, found);
  return found;
}

void RotationModel::append_occluder(const Segment& edge, FaceIndex f, std::vector<Occluder>& found) const {
  const RotatedFace& face = faces_[f];
  const Vector3& about = vertices_[corners_[face.first_corner].vertex];
  const std::int64_t from = geometry::dot(face.normal, minus(edge.from, about));
  const std::int64_t to = geometry::dot(face.normal, minus(edge.to, about));
  if (from < 0 || to < 0) found.push_back({f, 1, from, to});
  if (face.sheet && (from > 0 || to > 0)) found.push_back({f, -1, -from, -to});
}

// FNV-1a over everything on which events depend.
void RotationModel::take_fingerprint() {
  std::uint64_t hash = 14695981039346656037ULL;
  const auto add = [&hash](std::uint64_t value) {
    for (int i = 0; i < 8; ++i) hash = (hash ^ ((value >> (8 * i)) & 0xFFU)) * 1099511628211ULL;
  };
  add(vertices_.size());
  for (const Vector3& v : vertices_) {
    for (const std::int64_t c : v) add(static_cast<std::uint64_t>(c));
  }
  for (FaceIndex f = 0; f < faces_.size(); ++f) {
    add(faces_[f].corner_count * 2ULL + (faces_[f].sheet ? 1 : 0));
    for (const Corner& corner : corners(f)) add((std::uint64_t{corner.vertex} << 32U) | corner.next);
  }
  fingerprint_ = hash;
}

}  // namespace sightline::algorithms::plantinga
