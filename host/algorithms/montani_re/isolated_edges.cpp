#include "host/algorithms/montani_re/isolated_edges.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/geometry/box_tree.hpp"
#include "host/geometry/predicates.hpp"
#include "host/scene/read/poly_triangulate.hpp"

namespace sightline::algorithms::montani_re {
namespace {

using geometry::Box;
using geometry::Point2;

using PointRings = std::vector<std::vector<Point2>>;

// A face that can occlude.
struct Occluder {
  std::size_t body = 0;
  const scene::PolyFace* face = nullptr;
  geometry::Plane plane;
  int eye_side = 0;  // 0: edge-on
};

Point2 doubled(const scene::PolyPoint& p, std::size_t dropped) {
  const Point2 flat = geometry::flattened(p, dropped);
  return {2 * flat[0], 2 * flat[1]};
}

int eye_side_of(const geometry::Plane& plane, const scene::PolyCamera& camera) {
  return camera.perspective
             ? plane.side(camera.eye)
             : -geometry::sign(geometry::dot(plane.normal, geometry::vector_of(camera.forward)));
}

Box box_of(const scene::PolyScene& scene, std::span<const scene::VertexIndex> corners) {
  Box box{scene.vertices[corners[0]], scene.vertices[corners[0]]};
  for (const scene::VertexIndex v : corners) {
    for (std::size_t a = 0; a < 3; ++a) {
      box.low[a] = std::min(box.low[a], scene.vertices[v][a]);
      box.high[a] = std::max(box.high[a], scene.vertices[v][a]);
    }
  }
  return box;
}

Box box_around(const std::vector<Box>& boxes) {
  Box around = boxes[0];
  for (const Box& box : boxes) {
    for (std::size_t a = 0; a < 3; ++a) {
      around.low[a] = std::min(around.low[a], box.low[a]);
      around.high[a] = std::max(around.high[a], box.high[a]);
    }
  }
  return around;
}

// The rings of the face projected along an axis. Coordinates are doubled, so that midpoints of edges are integers.
PointRings flattened(const scene::PolyScene& scene, const scene::PolyFace& face, std::size_t dropped) {
  PointRings rings;
  const auto add = [&](std::span<const scene::VertexIndex> ring) {
    auto& points = rings.emplace_back();
    for (const scene::VertexIndex v : ring) points.push_back(doubled(scene.vertices[v], dropped));
  };
  add(face.outline);
  for (const auto& hole : face.holes) add(hole);
  return rings;
}

bool inside(const PointRings& rings, const Point2& p) {
  if (geometry::locate_in_ring(rings[0], p) <= 0) return false;
  return std::all_of(rings.begin() + 1, rings.end(),
                     [&p](const auto& hole) { return geometry::locate_in_ring(hole, p) < 0; });
}

bool crosses(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return geometry::sign(geometry::turn(a, b, c)) * geometry::sign(geometry::turn(a, b, d)) < 0 &&
         geometry::sign(geometry::turn(c, d, a)) * geometry::sign(geometry::turn(c, d, b)) < 0;
}

// Whether part of the segment may be inside the face: an end or the midpoint is inside, or the segment crosses the
// outline or passes one of its corners.
bool may_run_inside(const scene::PolyScene& scene, const Occluder& occluder, const scene::PolyPoint& from,
                    const scene::PolyPoint& to) {
  const std::size_t dropped = geometry::dominant_axis(occluder.plane.normal);
  const PointRings rings = flattened(scene, *occluder.face, dropped);
  const Point2 a = doubled(from, dropped);
  const Point2 b = doubled(to, dropped);
  const Point2 middle{a[0] / 2 + b[0] / 2, a[1] / 2 + b[1] / 2};
  if (inside(rings, a) || inside(rings, b) || inside(rings, middle)) return true;
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point2& c = ring[i];
      const bool passes = c != a && c != b && geometry::on_segment(a, b, c);
      if (passes || crosses(a, b, c, ring[i + 1 == ring.size() ? 0 : i + 1])) return true;
    }
  }
  return false;
}

class IsolatedEdges {
 public:
  IsolatedEdges(const scene::PolyScene& scene, const scene::PolyCamera& camera) : scene_(scene), camera_(camera) {
    for (const scene::PolyBody& body : scene.bodies) {
      if (!body.sheet) continue;
      for (const scene::PolyFace& face : body.faces) {
        if (eye_side_of(plane_of(face), camera) == 0)
          for_each_edge(face, [this](VertexIndex from, VertexIndex to) { add(from, to); });
      }
    }
  }

  // Most bodies touch no other body. Only the faces of those that do are compared.
  void add_behind_faces() {
    const std::vector<std::uint32_t> bodies = bodies_that_touch();
    for (const std::uint32_t b : bodies) add_occluders(b);
    constexpr std::size_t few = 8;
    const geometry::BoxTree tree(boxes_);
    std::vector<Box> face_boxes;
    std::vector<std::uint32_t> near;
    for (const std::uint32_t b : bodies) {
      const scene::PolyBody& body = scene_.bodies[b];
      const auto may_hide = [&](std::uint32_t number) { return occluders_[number].body != b || body.sheet; };
      face_boxes.clear();
      for (const scene::PolyFace& face : body.faces) face_boxes.push_back(box_of(scene_, face.outline));
      near.clear();
      tree.for_each_touching(box_around(face_boxes), [&](std::uint32_t number) {
        if (may_hide(number)) near.push_back(number);
      });
      if (near.empty()) continue;
      for (std::size_t f = 0; f < body.faces.size(); ++f) {
        const geometry::Vector3 normal = scene::ring_normal(scene_.vertices, body.faces[f].outline);
        const auto add_if_behind = [&](std::uint32_t number) {
          if (may_hide(number)) add_behind(occluders_[number], body.faces[f], normal);
        };
        if (near.size() > few) {
          tree.for_each_touching(face_boxes[f], add_if_behind);
        } else {
          for (const std::uint32_t number : near) add_if_behind(number);
        }
      }
    }
  }

  std::vector<picture::LineEdge> take() {
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    return std::move(edges_);
  }

 private:
  using VertexIndex = scene::VertexIndex;

  template <class Visit>
  static void for_each_edge(const scene::PolyFace& face, const Visit& visit) {
    const auto walk = [&visit](std::span<const VertexIndex> ring) {
      for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]);
    };
    walk(face.outline);
    for (const auto& hole : face.holes) walk(hole);
  }

  // Bodies whose box touches the box of another body, and all sheets, because faces of one sheet may touch each other.
  [[nodiscard]] std::vector<std::uint32_t> bodies_that_touch() const {
    std::vector<Box> body_boxes;
    std::vector<std::uint32_t> with_faces;
    for (std::uint32_t b = 0; b < scene_.bodies.size(); ++b) {
      const scene::PolyBody& body = scene_.bodies[b];
      if (body.faces.empty()) continue;
      Box around = box_of(scene_, body.faces[0].outline);
      for (const scene::PolyFace& face : body.faces) {
        for (const VertexIndex v : face.outline) {
          for (std::size_t a = 0; a < 3; ++a) {
            around.low[a] = std::min(around.low[a], scene_.vertices[v][a]);
            around.high[a] = std::max(around.high[a], scene_.vertices[v][a]);
          }
        }
      }
      body_boxes.push_back(around);
      with_faces.push_back(b);
    }
    const geometry::BoxTree tree(body_boxes);
    std::vector<std::uint32_t> bodies;
    for (std::uint32_t k = 0; k < with_faces.size(); ++k) {
      bool touches = scene_.bodies[with_faces[k]].sheet;
      tree.for_each_touching(body_boxes[k], [&](std::uint32_t other) { touches = touches || other != k; });
      if (touches) bodies.push_back(with_faces[k]);
    }
    return bodies;
  }

  void add_occluders(std::size_t b) {
    const scene::PolyBody& body = scene_.bodies[b];
    for (const scene::PolyFace& face : body.faces) {
      Occluder occluder{b, &face, plane_of(face), 0};
      occluder.eye_side = eye_side_of(occluder.plane, camera_);
      if (occluder.eye_side == 0 || (!body.sheet && occluder.eye_side < 0)) continue;
      occluders_.push_back(occluder);
      boxes_.push_back(box_of(scene_, face.outline));
    }
  }

  [[nodiscard]] geometry::Plane plane_of(const scene::PolyFace& face) const {
    const geometry::Vector3 normal = scene::ring_normal(scene_.vertices, face.outline);
    return {normal, geometry::dot(normal, geometry::vector_of(scene_.vertices[face.outline[0]]))};
  }

  // Adds the edges of a face that touch the back of an occluder.
  void add_behind(const Occluder& occluder, const scene::PolyFace& face, const geometry::Vector3& normal) {
    for_each_edge(face, [&](VertexIndex from, VertexIndex to) {
      if (touches_back(occluder, normal, from, to)) add(from, to);
    });
  }

  // Whether the edge is in the plane of the occluder while the face to its left is beyond that plane.
  [[nodiscard]] bool touches_back(const Occluder& occluder, const geometry::Vector3& normal, VertexIndex from,
                                  VertexIndex to) const {
    const scene::PolyPoint& a = scene_.vertices[from];
    const scene::PolyPoint& b = scene_.vertices[to];
    if (occluder.plane.side(a) != 0 || occluder.plane.side(b) != 0) return false;
    const geometry::Vector3 inward = geometry::cross(normal, geometry::difference(b, a));
    geometry::Int128 beyond = 0;  // 40 and 60 bits
    for (std::size_t k = 0; k < 3; ++k) beyond += geometry::Int128{inward[k]} * occluder.plane.normal[k];
    return (beyond > 0 ? 1 : beyond < 0 ? -1 : 0) * occluder.eye_side < 0 && may_run_inside(scene_, occluder, a, b);
  }

  void add(VertexIndex from, VertexIndex to) {
    if (from != to) edges_.push_back({std::min(from, to), std::max(from, to)});
  }

  const scene::PolyScene& scene_;
  const scene::PolyCamera& camera_;
  std::vector<Occluder> occluders_;
  std::vector<Box> boxes_;  // of the occluders
  std::vector<picture::LineEdge> edges_;
};

}  // namespace

std::vector<picture::LineEdge> isolated_edges(const scene::PolyScene& scene, const scene::PolyCamera& camera) {
  IsolatedEdges edges(scene, camera);
  edges.add_behind_faces();
  return edges.take();
}

}  // namespace sightline::algorithms::montani_re
