#include "host/picture/line_picture.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "host/geometry/integer.hpp"
#include "host/geometry/predicates.hpp"
#include "host/scene/model/vertex_pool.hpp"

namespace sightline::picture {

namespace {

void append_ring(std::span<const scene::VertexIndex> ring, std::vector<LineEdge>& edges) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const scene::VertexIndex a = ring[i];
    const scene::VertexIndex b = ring[i + 1 == ring.size() ? 0 : i + 1];
    if (a != b) edges.push_back({std::min(a, b), std::max(a, b)});
  }
}

using geometry::cross;
using geometry::difference;
using geometry::dot;
using geometry::Int128;
using geometry::sign;
using scene::VertexIndex;
using Vector = geometry::Vector3;

Int128 wide_dot(const Vector& a, const Vector& b) {
  return Int128{a[0]} * b[0] + Int128{a[1]} * b[1] + Int128{a[2]} * b[2];
}

// A face at an edge, as a direction in the face, away from the edge and not along it. Below 2^19.
struct Spoke {
  LineEdge edge;
  Vector away{};
};

// Spokes of the edges of a picture, ascending by edge. Equal points count as one vertex, the first of them.
class Spokes {
 public:
  Spokes(const scene::PolyScene& scene, const LinePicture& picture)
      : scene_(scene), first_at_(scene.vertices.size()), drawn_(scene.vertices.size()) {
    find_equal_points(picture);
    find_edges(picture);
    for (const scene::PolyBody& body : scene.bodies) {
      for (const scene::PolyFace& face : body.faces) add(face);
    }
    std::sort(spokes_.begin(), spokes_.end(), [](const Spoke& a, const Spoke& b) { return a.edge < b.edge; });
  }

  [[nodiscard]] std::vector<Vector> at(const LineEdge& edge) const {
    const LineEdge known = known_as(edge.from, edge.to);
    auto it = std::lower_bound(spokes_.begin(), spokes_.end(), known,
                               [](const Spoke& spoke, const LineEdge& e) { return spoke.edge < e; });
    std::vector<Vector> directions;
    for (; it != spokes_.end() && it->edge == known; ++it) directions.push_back(it->away);
    return directions;
  }

 private:
  // Finds the vertices at the same points as ends of edges of the picture. Most vertices are at none.
  void find_equal_points(const LinePicture& picture) {
    std::vector<scene::PolyPoint> ends;
    scene::VertexPool<std::int32_t> pool(ends);
    for (const LinePiece& piece : picture.pieces)
      for (const VertexIndex v : {piece.edge.from, piece.edge.to}) pool.add(scene_.vertices[v]);
    constexpr VertexIndex none = ~VertexIndex{0};
    std::vector<VertexIndex> first(ends.size(), none);
    for (VertexIndex v = 0; v < first_at_.size(); ++v) {
      first_at_[v] = v;
      const auto end = pool.find(scene_.vertices[v]);
      if (!end) continue;
      drawn_[v] = true;
      if (first[*end] == none) first[*end] = v;
      first_at_[v] = first[*end];
    }
  }

  // Only edges of the picture get spokes: in a large scene few edges are visible, and the spokes of all would take most
  // of the memory.
  void find_edges(const LinePicture& picture) {
    for (const LinePiece& piece : picture.pieces) {
      const LineEdge known = known_as(piece.edge.from, piece.edge.to);
      if (edges_.empty() || edges_.back() != known) edges_.push_back(known);
    }
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    first_edge_.resize(scene_.vertices.size() + 1);
    for (const LineEdge& edge : edges_) ++first_edge_[edge.from + 1];
    for (std::size_t v = 1; v < first_edge_.size(); ++v) first_edge_[v] += first_edge_[v - 1];
  }

  [[nodiscard]] bool is_drawn(VertexIndex a, VertexIndex b) const {
    if (!drawn_[a] || !drawn_[b]) return false;
    const LineEdge known = known_as(a, b);
    const auto begin = edges_.begin() + static_cast<std::ptrdiff_t>(first_edge_[known.from]);
    const auto end = edges_.begin() + static_cast<std::ptrdiff_t>(first_edge_[known.from + 1]);
    return std::find(begin, end, known) != end;
  }

  [[nodiscard]] LineEdge known_as(VertexIndex a, VertexIndex b) const {
    return {std::min(first_at_[a], first_at_[b]), std::max(first_at_[a], first_at_[b])};
  }

  [[nodiscard]] Vector step(VertexIndex from, VertexIndex to) const {
    return difference(scene_.vertices[to], scene_.vertices[from]);
  }

  void add(const scene::PolyFace& face) {
    if (!has_drawn(face.outline) && std::none_of(face.holes.begin(), face.holes.end(),
                                                 [this](const auto& hole) { return has_drawn(hole); }))
      return;
    Vector normal{};
    for (std::size_t i = 0; i < face.outline.size(); ++i) {
      const Vector part =
          cross(step(face.outline[0], face.outline[i]),
                step(face.outline[0], face.outline[i + 1 == face.outline.size() ? 0 : i + 1]));
      for (std::size_t axis = 0; axis < 3; ++axis) normal[axis] += part[axis];
    }
    add_ring(face.outline, face.outline, normal);
    for (const auto& hole : face.holes) add_ring(hole, face.outline, normal);
  }

  [[nodiscard]] bool has_drawn(std::span<const VertexIndex> ring) const {
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (is_drawn(ring[i], ring[i + 1 == ring.size() ? 0 : i + 1])) return true;
    return false;
  }

  // Every ring has the face to its left, as seen from the end of the normal. Any corner that is not on the line of a side
  // gives a direction into the face or exactly out of it.
  void add_ring(std::span<const VertexIndex> ring, std::span<const VertexIndex> corners,
                const Vector& normal) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const VertexIndex p = ring[i];
      const VertexIndex q = ring[i + 1 == ring.size() ? 0 : i + 1];
      if (!is_drawn(p, q)) continue;
      const Vector inward = cross(normal, step(p, q));
      for (const VertexIndex corner : corners) {
        Vector away = step(p, corner);
        const int hand = sign(wide_dot(inward, away));
        if (hand == 0) continue;
        for (std::int64_t& part : away) part *= hand;
        spokes_.push_back({known_as(p, q), away});
        break;
      }
    }
  }

  const scene::PolyScene& scene_;
  std::vector<VertexIndex> first_at_;
  std::vector<bool> drawn_;                 // by vertex: an edge of the picture ends there
  std::vector<LineEdge> edges_;             // ascending
  std::vector<std::uint32_t> first_edge_;  // by vertex
  std::vector<Spoke> spokes_;
};

// Directions about an axis, measured from the direction of the eye.
class Circle {
 public:
  Circle(const Vector& axis, const Vector& eye) : axis_(axis), eye_(eye) {}

  // 0: towards the eye, 1: less than half a turn, 2: half, 3: more.
  [[nodiscard]] int quarter(const Vector& a) const {
    const int turn = sign(dot(cross(axis_, eye_), a));
    if (turn != 0) return turn > 0 ? 1 : 3;
    return along(eye_, a) > 0 ? 0 : 2;
  }

  [[nodiscard]] bool before(const Vector& a, const Vector& b) const {
    const int qa = quarter(a);
    const int qb = quarter(b);
    return qa != qb ? qa < qb : dot(cross(axis_, a), b) > 0;
  }

  [[nodiscard]] bool opposite(const Vector& a, const Vector& b) const {
    return dot(cross(axis_, a), b) == 0 && along(a, b) < 0;
  }

 private:
  [[nodiscard]] int along(const Vector& a, const Vector& b) const {
    return sign(wide_dot(cross(axis_, a), cross(axis_, b)));
  }

  Vector axis_;
  Vector eye_;
};

bool is_seam(std::vector<Vector> spokes, const Circle& circle) {
  if (spokes.size() < 2) return false;
  std::sort(spokes.begin(), spokes.end(),
            [&circle](const Vector& a, const Vector& b) { return circle.before(a, b); });
  const Vector& first = spokes.front();
  const Vector& last = spokes.back();
  if (circle.quarter(first) != 0) return circle.opposite(last, first);
  const auto next = std::find_if(spokes.begin(), spokes.end(),
                                 [&circle](const Vector& spoke) { return circle.quarter(spoke) != 0; });
  return next != spokes.end() && circle.opposite(first, *next) && circle.opposite(last, first);
}

}  // namespace

std::vector<LineEdge> edges_of(const scene::PolyScene& scene) {
  std::vector<LineEdge> edges;
  std::size_t sides = scene.wires.size();
  for (const scene::PolyBody& body : scene.bodies) {
    for (const scene::PolyFace& face : body.faces) {
      sides += face.outline.size();
      for (const auto& hole : face.holes) sides += hole.size();
    }
  }
  edges.reserve(sides);
  for (const scene::PolyBody& body : scene.bodies) {
    for (const scene::PolyFace& face : body.faces) {
      append_ring(face.outline, edges);
      for (const auto& hole : face.holes) append_ring(hole, edges);
    }
  }
  for (const auto& [a, b] : scene.wires)
    if (a != b) edges.push_back({std::min(a, b), std::max(a, b)});
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

LinePicture without_seams(const LinePicture& picture, const scene::PolyScene& scene,
                          const scene::PolyCamera& camera) {
  const Spokes spokes(scene, picture);
  const Vector forward = geometry::vector_of(camera.forward);
  LinePicture features;
  for (const LinePiece& piece : picture.pieces) {
    const scene::PolyPoint& from = scene.vertices[piece.edge.from];
    const Vector axis = difference(scene.vertices[piece.edge.to], from);
    const Vector eye =
        camera.perspective ? difference(camera.eye, from) : Vector{-forward[0], -forward[1], -forward[2]};
    if (!is_seam(spokes.at(piece.edge), Circle(axis, eye))) features.pieces.push_back(piece);
  }
  return features;
}

}  // namespace sightline::picture
