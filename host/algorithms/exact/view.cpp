#include "host/algorithms/exact/view.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "host/geometry/integer.hpp"

namespace sightline::algorithms::exact {
namespace {

using geometry::cross;
using geometry::dot;
using geometry::Int128;
using geometry::vector_of;

constexpr double infinity = std::numeric_limits<double>::infinity();

// Where vertices are seen: quotients of integers below 2^37, so rounded once and in order.
class Projector {
 public:
  Projector(const View& view, const scene::PolyCamera& camera)
      : view_(view), axes_{vector_of(camera.right), vector_of(camera.up)}, image_(view.points.size()) {
    for (std::size_t v = 0; v < image_.size(); ++v) {
      const double over = view.perspective ? static_cast<double>(view.depths[v]) : 1.0;
      for (std::size_t axis = 0; axis < 2; ++axis) {
        image_[v][axis] = static_cast<double>(dot(axes_[axis], view.points[v])) / over;
      }
    }
  }

  [[nodiscard]] bool before_eye(std::uint32_t v) const { return !view_.perspective || view_.depths[v] > 0; }

  static ImageBounds nothing() { return {{infinity, infinity}, {-infinity, -infinity}}; }

  // Extends bounds by what is before the eye of the segment from p to q, but for q itself.
  void extend(ImageBounds& bounds, std::uint32_t p, std::uint32_t q) const {
    if (before_eye(p)) extend(bounds, p);
    if (before_eye(p) == before_eye(q)) return;
    // The segment runs out to infinity in the direction of its point beside the eye.
    const std::uint32_t seen = before_eye(p) ? p : q;
    const std::uint32_t behind = before_eye(p) ? q : p;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const Int128 direction = Int128{dot(axes_[axis], view_.points[behind])} * view_.depths[seen] -
                               Int128{dot(axes_[axis], view_.points[seen])} * view_.depths[behind];
      if (direction > 0) bounds.high[axis] = infinity;
      if (direction < 0) bounds.low[axis] = -infinity;
    }
  }

  void extend(ImageBounds& bounds, std::uint32_t v) const {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      bounds.low[axis] = std::min(bounds.low[axis], image_[v][axis]);
      bounds.high[axis] = std::max(bounds.high[axis], image_[v][axis]);
    }
  }

 private:
  const View& view_;
  std::array<Vector, 2> axes_;
  std::vector<std::array<double, 2>> image_;
};

void place_points(View& view, const scene::PolyCamera& camera) {
  const Vector eye = vector_of(camera.eye);
  const Vector forward = vector_of(camera.forward);
  const std::size_t count = view.mesh->vertices.size();
  view.points.resize(count);
  view.depths.resize(count);
  for (std::size_t v = 0; v < count; ++v) {
    view.points[v] = difference(view.mesh->vertices[v], eye);
    view.depths[v] = dot(forward, view.points[v]);
  }
}

void place_edges(View& view, const Vector& forward, const Projector& projector) {
  const std::size_t count = view.mesh->edges.size();
  view.planes.resize(count);
  view.bounds.assign(count, Projector::nothing());
  for (std::size_t e = 0; e < count; ++e) {
    const picture::LineEdge& edge = view.mesh->edges[e];
    const Vector& p = view.points[edge.from];
    const Vector& q = view.points[edge.to];
    Plane& plane = view.planes[e];
    if (view.perspective) {
      plane.normal = cross(p, q);
    } else {
      plane.normal = cross(forward, difference(q, p));
      plane.offset = dot(plane.normal, p);
    }
    projector.extend(view.bounds[e], edge.from, edge.to);
    if (projector.before_eye(edge.to)) projector.extend(view.bounds[e], edge.to);
  }
}

void place_faces(View& view, const Vector& forward, const Projector& projector) {
  const EdgeMesh& mesh = *view.mesh;
  view.drawn.assign(mesh.edges.size(), 0);
  for (const MeshFace& face : mesh.faces) {
    const Corner* const corners = &mesh.corners[face.first_corner];
    const std::int64_t offset = dot(face.normal, view.points[corners->vertex]);
    const std::int64_t away = view.perspective ? offset : dot(face.normal, forward);
    if (away > 0 && !face.sheet) continue;
    for (std::uint32_t i = 0; i < face.corner_count; ++i) view.drawn[corners[i].side] = 1;
    if (away == 0) continue;
    Occluder occluder{face.first_corner, face.corner_count, {face.normal, offset}, 0, Projector::nothing(), face.surface};
    if (away < 0) {  // positive beyond the face: against the normal
      for (std::int64_t& part : occluder.beyond.normal) part = -part;
      occluder.beyond.offset = -offset;
    }
    std::int64_t nearest = view.depths[corners->vertex];
    std::int64_t farthest = nearest;
    for (std::uint32_t i = 0; i < face.corner_count; ++i) {
      const std::uint32_t vertex = corners[i].vertex;
      projector.extend(occluder.bounds, vertex, corners[corners[i].next].vertex);
      nearest = std::min(nearest, view.depths[vertex]);
      farthest = std::max(farthest, view.depths[vertex]);
    }
    occluder.depth = nearest;
    if (!view.perspective || farthest > 0) view.occluders.push_back(occluder);
  }
  std::sort(view.occluders.begin(), view.occluders.end(), [](const Occluder& a, const Occluder& b) {
    return a.depth != b.depth ? a.depth < b.depth : a.first_corner < b.first_corner;
  });
}

}  // namespace

View make_view(const EdgeMesh& mesh, const scene::PolyCamera& camera, const picture::ChosenEdges* chosen) {
  View view;
  view.mesh = &mesh;
  view.perspective = camera.perspective;
  place_points(view, camera);
  const Projector projector(view, camera);
  place_edges(view, vector_of(camera.forward), projector);
  place_faces(view, vector_of(camera.forward), projector);
  if (chosen != nullptr) {
    view.drawn.assign(mesh.edges.size(), 0);
    auto edge = mesh.edges.begin();
    for (std::size_t c = 0; c < chosen->edges.size(); ++c) {
      edge = std::lower_bound(edge, mesh.edges.end(), chosen->edges[c]);
      if (edge == mesh.edges.end()) break;
      if (*edge == chosen->edges[c] && chosen->turned_away[c] == 0)
        view.drawn[static_cast<std::size_t>(edge - mesh.edges.begin())] = 1;
    }
  }
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const picture::LineEdge& edge = mesh.edges[e];
    const bool seen = projector.before_eye(edge.from) || projector.before_eye(edge.to);
    if (!seen || view.planes[e].normal == Vector{}) view.drawn[e] = 0;
  }
  return view;
}

}  // namespace sightline::algorithms::exact
