// See mended_mesh.hpp.
#include "host/scene/read/mended_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host/geometry/predicates.hpp"
#include "host/scene/check/poly_scene.hpp"

namespace sightline::scene {

EdgeTable MendedMesh::edge_table() const {
  std::vector<const Ring*> outlines;
  outlines.reserve(pieces.size());
  for (const Piece& piece : pieces) outlines.push_back(&piece.ring);
  return {points().size(), outlines, options.jobs};
}

double MendedMesh::deviation(const Ring& ring, const geometry::Vector3& normal) const {
  geometry::Int128 most = 0;
  for (const VertexIndex v : ring) {
    const auto height = geometry::wide_dot(normal, geometry::difference(points()[v], points()[ring[0]]));
    most = std::max(most, height < 0 ? -height : height);
  }
  double length = 0;
  for (const std::int64_t c : normal) length += static_cast<double>(c) * static_cast<double>(c);
  return static_cast<double>(most) / std::sqrt(length);
}

void MendedMesh::leave_out(Piece& piece, std::size_t& count) {
  piece.left_out = true;
  piece.ring.clear();
  ++count;
}

void MendedMesh::sort_pieces() {
  std::stable_sort(pieces.begin(), pieces.end(), by_source);
}

void MendedMesh::add_fault(const Piece& piece, const std::string& text) {
  if (names_faults()) faults.add(place_of(piece), text);
}

std::string MendedMesh::place_of(const Piece& piece) const { return face_place(scene, piece.body, face_in_body(piece)); }

void remove_spikes(Ring& ring) {
  bool changed = true;
  while (changed && ring.size() >= 3) {
    changed = false;
    Ring kept;
    for (const VertexIndex v : ring) {
      if (!kept.empty() && kept.back() == v) continue;
      if (kept.size() >= 2 && kept[kept.size() - 2] == v) {
        kept.pop_back();
        continue;
      }
      kept.push_back(v);
    }
    const auto matches = [&kept](std::size_t i, std::size_t from_end) {
      return kept[i] == kept[kept.size() - from_end];
    };
    while (kept.size() >= 2 && matches(0, 1)) kept.pop_back();
    while (kept.size() >= 3 && (matches(0, 2) || matches(1, 1))) {
      kept.pop_back();
      while (kept.size() >= 2 && matches(0, 1)) kept.pop_back();
    }
    changed = kept.size() != ring.size();
    ring = std::move(kept);
  }
  if (ring.size() < 3) ring.clear();
}

}  // namespace sightline::scene
