#include "host/algorithms/montani_re/pyramids.hpp"

#include <algorithm>
#include <utility>

#include "host/algorithms/montani_re/isolated_edges.hpp"
#include "host/geometry/predicates.hpp"
#include "host/scene/read/poly_triangulate.hpp"

namespace sightline::algorithms::montani_re {
namespace {

struct Pyramid {
  PyramidFrame frame;
  WindowBounds window;
};

// Ahead; to the right and left; above and below. z = 0 is a border of four: nothing is seen there.
constexpr std::array<Pyramid, 5> pyramids{{{{{0, 1, 2}, false}, {{-2, -2}, {2, 2}, 1}},
                                           {{{2, 1, 0}, false}, {{0, -2}, {1, 2}, 1}},
                                           {{{2, 1, 0}, true}, {{0, -2}, {1, 2}, 1}},
                                           {{{2, 0, 1}, false}, {{0, -2}, {1, 2}, 1}},
                                           {{{2, 0, 1}, true}, {{0, -2}, {1, 2}, 1}}}};

// Not the side that is seen is turned to the eye, or the face is edge-on.
bool turned_away(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                 const scene::PolyFace& face) {
  const geometry::Vector3 normal = scene::ring_normal(scene.vertices, face.outline);
  const geometry::Vector3 sight = camera.perspective
                                      ? geometry::difference(scene.vertices[face.outline[0]], camera.eye)
                                      : geometry::vector_of(camera.forward);
  return geometry::dot(normal, sight) >= 0;
}

std::size_t corners_behind(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                           const scene::PolyFace& face) {
  return static_cast<std::size_t>(
      std::count_if(face.outline.begin(), face.outline.end(),
                    [&](scene::VertexIndex v) { return !before_eye(scene, camera, v); }));
}

// Visits (body, face) of all that may be seen and is not wholly behind the eye.
template <class Visit>
void for_each_face(const scene::PolyScene& scene, const scene::PolyCamera& camera, const Visit& visit) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const scene::PolyBody& body = scene.bodies[b];
    for (std::size_t f = 0; f < body.faces.size(); ++f) {
      if (!body.sheet && turned_away(scene, camera, body.faces[f])) continue;
      if (corners_behind(scene, camera, body.faces[f]) == body.faces[f].outline.size()) continue;
      visit(b, f);
    }
  }
}

FaceSet make_set(const scene::PolyScene& scene, const scene::PolyCamera& camera, const PyramidFrame& frame,
                 const WindowBounds* window, const std::vector<picture::LineEdge>& lone) {
  FaceSetBuilder builder(camera.perspective);
  for (const scene::PolyPoint& point : scene.vertices) {
    const geometry::Vector3 d = geometry::difference(point, camera.eye);
    const std::array<std::int64_t, 3> p{geometry::dot(geometry::vector_of(camera.right), d),
                                        geometry::dot(geometry::vector_of(camera.up), d),
                                        geometry::dot(geometry::vector_of(camera.forward), d)};
    const std::int64_t depth = p[frame.axes[2]];
    builder.add_vertex({p[frame.axes[0]], p[frame.axes[1]], frame.turned ? -depth : depth});
  }
  if (window != nullptr) builder.clip_to(*window);
  Rings rings;  // their room is kept from face to face
  for_each_face(scene, camera, [&](std::size_t b, std::size_t f) {
    const scene::PolyFace& face = scene.bodies[b].faces[f];
    rings.resize(1 + face.holes.size());
    rings[0] = face.outline;
    std::copy(face.holes.begin(), face.holes.end(), rings.begin() + 1);
    builder.add_face(rings, static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(f));
  });
  for (const picture::LineEdge& edge : lone) builder.add_isolated_edge(edge.from, edge.to);
  return builder.take();
}

}  // namespace

bool before_eye(const scene::PolyScene& scene, const scene::PolyCamera& camera, scene::VertexIndex vertex) {
  return !camera.perspective || geometry::dot(geometry::vector_of(camera.forward),
                                              geometry::difference(scene.vertices[vertex], camera.eye)) > 0;
}

std::optional<std::array<std::size_t, 2>> face_past_eye(const scene::PolyScene& scene,
                                                        const scene::PolyCamera& camera) {
  std::optional<std::array<std::size_t, 2>> found;
  if (!camera.perspective) return found;
  for_each_face(scene, camera, [&](std::size_t b, std::size_t f) {
    if (!found && corners_behind(scene, camera, scene.bodies[b].faces[f]) != 0) found = {b, f};
  });
  return found;
}

FaceSet faces_seen(const scene::PolyScene& scene, const scene::PolyCamera& camera, const PyramidFrame& frame,
                   const WindowBounds* window) {
  return make_set(scene, camera, frame, window, isolated_edges(scene, camera));
}

std::vector<FaceSet> faces_before_eye(const scene::PolyScene& scene, const scene::PolyCamera& camera) {
  std::vector<FaceSet> sets;
  if (!face_past_eye(scene, camera)) {
    sets.push_back(faces_seen(scene, camera));
    return sets;
  }
  const std::vector<picture::LineEdge> lone = isolated_edges(scene, camera);
  for (const Pyramid& pyramid : pyramids) {
    FaceSet set = make_set(scene, camera, pyramid.frame, &pyramid.window, lone);
    if (!set.faces.empty() || !set.lone.empty()) sets.push_back(std::move(set));
  }
  return sets;
}

}  // namespace sightline::algorithms::montani_re
